// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnSurfaceShader
 * @brief   a program for the colour of visible points
 *
 * What a fragment shader is to a GPU: derive a class, write Shade(), and give an object of it to
 * vtkLimnProperty::SetSurfaceShader(). It replaces what the property's ReflectionModel and Tone
 * would compute, and may call that. It runs for every pixel, whatever ShadingFrequency says; an
 * outline is drawn over what it gives.
 *
 * Objects are to call Modified() when what they draw changes, as the setters of VTK's macros do.
 * The picture is the same with any number of threads, and the same as the reference renderer's, as
 * long as the colour of a fragment depends on that fragment and on the object's own settings only.
 * For the same bytes on every machine keep to + - * / and std::sqrt, and compile with
 * -ffp-contract=off.
 *
 * Shaders are written in C++: VTK's wrapping lets no Python class override a C++ method. Actors
 * that VTK's own mapper draws in Limn's stead (see vtkLimnPolyDataMapper) show nothing of them.
 *
 * @sa
 * vtkLimnProperty vtkLimnVertexShader
 */

#ifndef vtkLimnSurfaceShader_h
#define vtkLimnSurfaceShader_h

#include "vtkLimnModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for std::unique_ptr

class VTKLIMN_EXPORT vtkLimnSurfaceShader : public vtkObject
{
public:
  vtkTypeMacro(vtkLimnSurfaceShader, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Most fragments of one call, and the size of every array of numbers below, of which the first
   * Fragments::Count mean something.
   */
  static constexpr int Capacity = 64;

  /**
   * One vector or colour for each fragment, an array a component.
   */
  struct Vectors
  {
    const float* X;
    const float* Y;
    const float* Z;
  };

  /**
   * Fragments of one actor: visible points, one for each triangle that a pixel shows.
   */
  struct Fragments
  {
    int Count;
    Vectors Position;      ///< in view coordinates: the eye at the origin, looking along -z
    Vectors ModelPosition; ///< in the coordinates of the mapper's points
    Vectors Normal;        ///< unit, in view coordinates, turned to the eye; with bump maps
    Vectors Ambient;       ///< k_a: of the property or the scalars, under surface textures
    Vectors Diffuse;       ///< k_d
    Vectors Specular;      ///< k_s
    const float* U;        ///< texture coordinates; null where no texture needs them
    const float* V;
    const int* PixelX; ///< from the viewport's lower left corner
    const int* PixelY;
    const unsigned int* Cell; ///< of the mapper's input
  };

  /**
   * What lights the fragments. `toward` and `color` are three arrays each.
   */
  class VTKLIMN_EXPORT Lighting
  {
  public:
    /**
     * The property's own model over these fragments, which may be copies with another normal, say,
     * or other reflectances.
     */
    virtual void Light(const Fragments& fragments, float* const color[3]) const = 0;

    ///@{
    /**
     * For models of one's own: the colour of each light, the unit vector towards it, and the factor
     * by which it has fallen off on its way to a fragment's Position; and the ambient light I_a.
     */
    virtual int GetNumberOfLights() const = 0;
    virtual void GetLightColor(int light, float color[3]) const = 0;
    virtual void Arrive(
      int light, const Fragments& fragments, float* const toward[3], float* fall) const = 0;
    virtual void GetAmbientLight(float color[3]) const = 0;
    ///@}

    ///@{
    /**
     * From model to world and from world to view coordinates, row by row; and whether the eye is
     * infinitely far away.
     */
    virtual void GetModelToWorld(double matrix[16]) const = 0;
    virtual void GetWorldToView(double matrix[16]) const = 0;
    virtual bool GetParallelProjection() const = 0;
    ///@}

  protected:
    Lighting() = default;
    virtual ~Lighting();

  private:
    Lighting(const Lighting&) = delete;
    void operator=(const Lighting&) = delete;
  };

  /**
   * Writes red, green and blue of all fragments; 1 is full. What is not a number counts as 0.
   * Called by several threads at once; it may not throw.
   */
  VTK_WRAPEXCLUDE virtual void Shade(
    const Fragments& fragments, const Lighting& lighting, float* const color[3]) const = 0;

  /**
   * For Limn's own use.
   */
  class vtkInternals;
  VTK_WRAPEXCLUDE const vtkInternals& GetInternals() const { return *this->Internals; }

protected:
  vtkLimnSurfaceShader();
  ~vtkLimnSurfaceShader() override;

private:
  vtkLimnSurfaceShader(const vtkLimnSurfaceShader&) = delete;
  void operator=(const vtkLimnSurfaceShader&) = delete;

  std::unique_ptr<vtkInternals> Internals;
};

#endif
