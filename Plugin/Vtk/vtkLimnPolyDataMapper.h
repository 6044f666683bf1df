// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnPolyDataMapper
 * @brief   draws the surface of polygonal data by Limn's rasterizer
 *
 * Polygons and triangle strips as a surface, coloured by the property, by scalars or by textures.
 * All such actors of a renderer are drawn together, by all cores of the CPU. What is prepared for
 * the geometry is kept until points or cells change; colours are mapped anew only if scalars or the
 * lookup table do.
 *
 * Translucent surfaces, by opacity, scalars or texture as VTK's actors define it, are sorted in
 * each sample; nothing has to be set for it, and the settings of depth peeling are not read. In an
 * OpenGL window those that Limn draws lie over all opaque actors, hidden where these are nearer,
 * and behind the translucent ones of the backend.
 *
 * What Limn does not draw yet (wireframe, points, lines, ...) is drawn by the window's own backend
 * in an OpenGL window. In a vtkLimnRenderWindow a warning says once what is missing.
 *
 * Arrays whose values are written in place have to be Modified() themselves, as for VTK's mapper;
 * of points it is enough that their data set is.
 *
 * @sa
 * vtkLimnActor vtkLimnProperty vtkLimnRenderWindow vtkLimnEngine vtkLimnVertexShader
 */

#ifndef vtkLimnPolyDataMapper_h
#define vtkLimnPolyDataMapper_h

#include "vtkLimnModule.h" // for export macro
#include "vtkPolyDataMapper.h"

#include <memory> // for std::unique_ptr

class vtkLimnVertexShader;

class VTKLIMN_EXPORT vtkLimnPolyDataMapper : public vtkPolyDataMapper
{
public:
  static vtkLimnPolyDataMapper* New();
  vtkTypeMacro(vtkLimnPolyDataMapper, vtkPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  bool GetSupportsSelection() override { return true; }
  bool HasTranslucentPolygonalGeometry() override;

  ///@{
  /**
   * A program that moves the points of the input before they are drawn; none by default.
   */
  virtual void SetVertexShader(vtkLimnVertexShader*);
  vtkGetObjectMacro(VertexShader, vtkLimnVertexShader);
  ///@}

  using vtkPolyDataMapper::GetBounds;
  /**
   * Of the points where the vertex shader, if there is one, moves them.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;

  /**
   * With the vertex shader's.
   */
  vtkMTimeType GetMTime() override;

  /**
   * The vertex shader is shared.
   */
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  /**
   * How often the geometry has been prepared since this mapper was made: a figure that stays the
   * same while only cameras, properties, scalars or lookup tables change, or points move a little.
   */
  vtkIdType GetNumberOfGeometryBuilds();

  /**
   * How often, since this mapper was made, the geometry has been moved along with points, for a
   * fraction of the cost: a figure that stays the same while only scalars change, in a pipeline
   * too.
   */
  vtkIdType GetNumberOfGeometryMoves();

  /**
   * The colours of the input's scalars, one per point (`cellFlag` 0), one per cell (1) or per tuple
   * of the field data (2); nullptr if the property colours the surface. Never colours that are
   * meant to be looked up in a texture, whatever InterpolateScalarsBeforeMapping says.
   */
  vtkUnsignedCharArray* MapScalarsToColors(int& cellFlag);

  /**
   * What is kept between frames. For Limn's own use.
   */
  class vtkInternals;
  VTK_WRAPEXCLUDE vtkInternals& GetInternals() { return *this->Internals; }

protected:
  vtkLimnPolyDataMapper();
  ~vtkLimnPolyDataMapper() override;

  /**
   * As VTK's, but cells that name points that do not exist, and coordinates that are not finite
   * numbers, are left out.
   */
  void ComputeBounds() override;

  vtkLimnVertexShader* VertexShader = nullptr;

private:
  vtkLimnPolyDataMapper(const vtkLimnPolyDataMapper&) = delete;
  void operator=(const vtkLimnPolyDataMapper&) = delete;

  std::unique_ptr<vtkInternals> Internals;
};

#endif
