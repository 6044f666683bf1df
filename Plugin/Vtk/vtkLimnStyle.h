// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnStyle
 * @brief   a renderer's surfaces in a style of illustration, by one word
 *
 * Each style is a set of values for the settings of vtkLimnProperty, and for some a background.
 * Apply() gives them to all actors of a renderer that Limn draws, so that an existing scene needs
 * one call. Colours, textures and data stay the actors' own. What a style has set can be changed
 * afterwards, property by property; another style starts anew from the defaults of vtkLimnProperty,
 * with the opacity and the background that were there before the first one, or the first after
 * plain.
 *
 * - plain: as VTK draws surfaces
 * - technical: warm and cool shades, contours heavier than creases
 * - gooch: warm and cool shades within contours
 * - toon: three even steps of light, heavy contours
 * - blueprint: white lines on blue, hidden ones dashed
 * - pencil: soft grey shades, tapered lines and strokes along the curvature, on paper
 * - ink: black lines and strokes along the curvature, on white
 * - anatomy: warm, matt shades of the actors' own colours, brown contours
 * - metal: bands of milled metal, contours and creases
 * - xray: bright where a surface turns away, all else seen through, on black
 * - print: two greys and black lines, their widths in points, for paper without colours
 *
 * Where a style has lines, where surfaces run into each other is one. Those are looked for again
 * whenever points move, on one core about a microsecond a triangle: IntersectionLinesOff() of the
 * property does without.
 *
 * Tones that keep to the legend are used over colours of data (vtkLimnProperty's ToneOverData), but
 * by blueprint, pencil, ink, metal, xray and print, which show no colours of their own.
 *
 * @sa
 * vtkLimnProperty
 */

#ifndef vtkLimnStyle_h
#define vtkLimnStyle_h

#include "vtkLimnModule.h" // for export macro
#include "vtkObject.h"

class vtkLimnProperty;
class vtkRenderer;

class VTKLIMN_EXPORT vtkLimnStyle : public vtkObject
{
public:
  static vtkLimnStyle* New();
  vtkTypeMacro(vtkLimnStyle, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The styles, in the order above; nullptr for an index that is none.
   */
  static int GetNumberOfStyles();
  static const char* GetStyleName(int index);
  ///@}

  ///@{
  /**
   * Gives all actors that are in the renderer now, parts of assemblies too, the style of this name,
   * and the renderer the style's background. An actor's vtkProperty that is not a vtkLimnProperty
   * is replaced by one with its values; actors that shared one still do. Actors whose mapper is not
   * Limn's keep their look. For a property alone the same without a background. False, with a
   * warning that names the styles, if there is none of that name.
   */
  static bool Apply(vtkRenderer* renderer, const char* name);
  static bool Apply(vtkLimnProperty* property, const char* name);
  ///@}

  /**
   * The background that a style asks for, to `rgb`; false if any will do, or there is no such
   * style.
   */
  static bool GetBackground(const char* name, double rgb[3]);

protected:
  vtkLimnStyle();
  ~vtkLimnStyle() override;

private:
  vtkLimnStyle(const vtkLimnStyle&) = delete;
  void operator=(const vtkLimnStyle&) = delete;
};

#endif
