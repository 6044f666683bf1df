// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnVertexShader
 * @brief   a program that moves points before they are drawn
 *
 * What a vertex shader is to a GPU: derive a class, write Move(), and give an object of it to
 * vtkLimnPolyDataMapper::SetVertexShader(). The input stays as it is; what is drawn, the mapper's
 * bounds and hardware selection follow the shader. It runs over all points in parallel, and only
 * when the points, the object (call Modified(), as the setters of VTK's macros do) or the mapper's
 * shader have changed. Pickers that read the input, as vtkCellPicker does, find it unmoved.
 *
 * Points that it moves to coordinates that are not finite numbers are named in a warning, and
 * their triangles left out. Shaders are written in C++: VTK's wrapping lets no Python class
 * override a C++ method. Actors that VTK's own mapper draws in Limn's stead (see
 * vtkLimnPolyDataMapper) are drawn unmoved.
 *
 * @sa
 * vtkLimnPolyDataMapper vtkLimnSurfaceShader
 */

#ifndef vtkLimnVertexShader_h
#define vtkLimnVertexShader_h

#include "vtkLimnModule.h" // for export macro
#include "vtkObject.h"

class VTKLIMN_EXPORT vtkLimnVertexShader : public vtkObject
{
public:
  vtkTypeMacro(vtkLimnVertexShader, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Some points of the input, which follow each other.
   */
  struct Vertices
  {
    int Count;
    vtkIdType First;     ///< number of the first of them in the input
    double* Position[3]; ///< to be changed in place, an array a component
    float* Normal[3];    ///< likewise; null unless MovesNormals() and the points have normals
  };

  /**
   * Moves points in place. They are rounded to floats where the input's are floats. Called by
   * several threads at once; it may not throw. Where a point goes shall depend on its position,
   * normal and number, and on the object's own settings only.
   */
  VTK_WRAPEXCLUDE virtual void Move(const Vertices& vertices) const = 0;

  /**
   * Whether Move() turns the normals too; they need not be unit. Where it does not, as by default,
   * the normals of points are computed anew from the moved triangles around each, and normals of
   * cells are those of the moved triangles.
   */
  virtual bool MovesNormals() const { return false; }

protected:
  vtkLimnVertexShader() = default;
  ~vtkLimnVertexShader() override = default;

private:
  vtkLimnVertexShader(const vtkLimnVertexShader&) = delete;
  void operator=(const vtkLimnVertexShader&) = delete;
};

#endif
