// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnToneLegend
 * @brief   a legend of value and tone: the colours that a toned surface really has
 *
 * A scalar bar shows the colours of a lookup table, but a surface with a tone has others. This
 * legend has both: the values of LookupTable from left to right, and the tone from below, where the
 * surface turns away from the light, to above, where it faces it; its colours are those that Limn
 * draws with SurfaceProperty under a headlight, without highlights and outlines. Tones that follow
 * more than the angle to the light, as metal and those by pictures do, have more colours than it
 * shows.
 *
 * In OpenGL windows it is a 2-D actor: a rectangle at Position, whose size is Position2, by default
 * a fifth and a twelfth of the viewport in its lower left corner. Limn's own window draws no 2-D
 * actors yet; GetImage() has the picture.
 *
 * GetReadBackError() says how well values can be read off the surface.
 *
 * NumberOfValues and NumberOfTones are clamped to their range (vtkSetClampMacro).
 *
 * @sa
 * vtkLimnProperty::SetToneOverData vtkScalarBarActor
 */

#ifndef vtkLimnToneLegend_h
#define vtkLimnToneLegend_h

#include "vtkActor2D.h"
#include "vtkLimnModule.h" // for export macro
#include "vtkNew.h"        // for the picture

class vtkImageData;
class vtkPolyData;
class vtkProperty;
class vtkScalarsToColors;

class VTKLIMN_EXPORT vtkLimnToneLegend : public vtkActor2D
{
public:
  static vtkLimnToneLegend* New();
  vtkTypeMacro(vtkLimnToneLegend, vtkActor2D);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whose colours are shown: the entries of a vtkLookupTable in their order, of others those of
   * values evenly over the range. Initially none, and then there is no legend.
   */
  virtual void SetLookupTable(vtkScalarsToColors* table);
  vtkGetObjectMacro(LookupTable, vtkScalarsToColors);
  ///@}

  ///@{
  /**
   * The look of the surface that the legend is for, as a rule a vtkLimnProperty. Initially none,
   * and then there is no legend.
   */
  virtual void SetSurfaceProperty(vtkProperty* property);
  vtkGetObjectMacro(SurfaceProperty, vtkProperty);
  ///@}

  ///@{
  /**
   * How many values and how many steps of tone the picture has, from 1 to 4096 and from 1 to 1024.
   * Defaults: 256 and 64.
   */
  vtkSetClampMacro(NumberOfValues, int, 1, 4096);
  vtkGetMacro(NumberOfValues, int);
  vtkSetClampMacro(NumberOfTones, int, 1, 1024);
  vtkGetMacro(NumberOfTones, int);
  ///@}

  /**
   * The legend as red, green and blue bytes, NumberOfValues x NumberOfTones pixels; it is this
   * object's, and made anew when something changes. nullptr, with an error, if there is no legend.
   */
  vtkImageData* GetImage();

  /**
   * How far off, as a share of the table's range, a value is on average that is read off a sphere
   * with evenly mixed values under a headlight, by the nearest in CIELAB of 128 colours of the
   * table. Negative, with an error, if there is no legend.
   */
  double GetReadBackError();

  /**
   * The most of vtkLimnProperty's LegendSafeRange, in steps of 0.5 up to 50, up to which the error
   * of GetReadBackError() stays at or below `error`. Maps whose values lie in their lightness
   * alone, as a grey scale's, allow little. 0 without a table, and, with a warning, for an error
   * that is negative or not finite.
   */
  static double FindLegendSafeRange(vtkScalarsToColors* table, double error);

  ///@{
  /**
   * VTK's calls to draw a 2-D actor.
   */
  int RenderOverlay(vtkViewport* viewport) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  ///@}

  void ShallowCopy(vtkProp* prop) override;
  vtkMTimeType GetMTime() override;

protected:
  vtkLimnToneLegend();
  ~vtkLimnToneLegend() override;

  vtkScalarsToColors* LookupTable = nullptr;
  vtkProperty* SurfaceProperty = nullptr;
  int NumberOfValues = 256;
  int NumberOfTones = 64;

private:
  vtkLimnToneLegend(const vtkLimnToneLegend&) = delete;
  void operator=(const vtkLimnToneLegend&) = delete;

  bool UpdateImage();
  bool UpdateRectangle(vtkViewport* viewport);

  vtkNew<vtkImageData> Image;
  vtkTimeStamp ImageTime;
  vtkNew<vtkPolyData> Rectangle;
  vtkTimeStamp RectangleTime;
  int RectangleSize[2] = { 0, 0 };
};

#endif
