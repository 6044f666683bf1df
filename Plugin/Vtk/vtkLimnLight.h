// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnLight
 * @brief   a vtkLight that may be a rectangle or a sphere, have a soft edge, or be given by its
 * power
 *
 * An ordinary vtkLight until one of its own settings is changed. Only surfaces that Limn draws see
 * these settings; for VTK's own mappers a rectangle or sphere is a point light at Position.
 *
 * Rectangles and spheres are sums of point lights, always at the same places: more of them make
 * smoother pictures that take longer. There are no shadows.
 *
 * Choices and Samples are clamped to their range (vtkSetClampMacro).
 *
 * @sa
 * vtkLimnPolyDataMapper vtkLimnProperty
 */

#ifndef vtkLimnLight_h
#define vtkLimnLight_h

#include "vtkLight.h"
#include "vtkLimnModule.h" // for export macro

class VTKLIMN_EXPORT vtkLimnLight : public vtkLight
{
public:
  static vtkLimnLight* New();
  vtkTypeMacro(vtkLimnLight, vtkLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Shapes
  {
    SHAPE_POINT = 0,
    SHAPE_RECTANGLE,
    SHAPE_SPHERE
  };

  ///@{
  /**
   * Point, the default: what vtkLight is, directional, point or spot. Rectangle: Width and Height
   * about Position, shining to the side of FocalPoint with the cosine to that direction. Sphere: of
   * Radius about Position, shining from all of its volume in all directions. Both are positional,
   * which setting them turns on, fall off by AttenuationValues, and have no cone.
   */
  void SetShape(int shape);
  vtkGetMacro(Shape, int);
  void SetShapeToPoint() { this->SetShape(SHAPE_POINT); }
  void SetShapeToRectangle() { this->SetShape(SHAPE_RECTANGLE); }
  void SetShapeToSphere() { this->SetShape(SHAPE_SPHERE); }
  const char* GetShapeAsString();
  ///@}

  ///@{
  /**
   * Sides of a rectangle, above 0, in the units of Position. Defaults: 1.
   */
  vtkSetMacro(Width, double);
  vtkGetMacro(Width, double);
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * The way of a rectangle's Height, as far as it is across the way to FocalPoint. Default:
   * (0, 1, 0).
   */
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Radius of a sphere, above 0, in the units of Position. Default: 0.5.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * How many point lights share the light of a rectangle or sphere, at least 1. Default: 16.
   */
  vtkSetClampMacro(Samples, int, 1, VTK_INT_MAX);
  vtkGetMacro(Samples, int);
  ///@}

  ///@{
  /**
   * Degrees inside the edge of a spot's cone over which the light fades, 0 to ConeAngle. Default:
   * 0, VTK's hard edge.
   */
  vtkSetMacro(SoftEdgeAngle, double);
  vtkGetMacro(SoftEdgeAngle, double);
  ///@}

  enum Units
  {
    UNIT_INTENSITY = 0,
    UNIT_POWER
  };

  ///@{
  /**
   * What colour times Intensity is. Intensity, the default, as VTK. Power, of positional lights:
   * what the light sends out in all directions, so that its intensity is P / 4 pi, of a rectangle
   * straight ahead P / pi; it falls off by the square of the distance, whatever AttenuationValues
   * says.
   */
  vtkSetClampMacro(Unit, int, UNIT_INTENSITY, UNIT_POWER);
  vtkGetMacro(Unit, int);
  void SetUnitToIntensity() { this->SetUnit(UNIT_INTENSITY); }
  void SetUnitToPower() { this->SetUnit(UNIT_POWER); }
  const char* GetUnitAsString();
  ///@}

  /**
   * Copies all settings, those of a vtkLimnLight too if `light` is one.
   */
  void DeepCopy(vtkLight* light);

  vtkLight* ShallowClone() override;

protected:
  vtkLimnLight() = default;
  ~vtkLimnLight() override = default;

  int Shape = SHAPE_POINT;
  double Width = 1.0;
  double Height = 1.0;
  double ViewUp[3] = { 0.0, 1.0, 0.0 };
  double Radius = 0.5;
  int Samples = 16;
  double SoftEdgeAngle = 0.0;
  int Unit = UNIT_INTENSITY;

private:
  void CopyOwnSettings(vtkLight* light);

  vtkLimnLight(const vtkLimnLight&) = delete;
  void operator=(const vtkLimnLight&) = delete;
};

#endif
