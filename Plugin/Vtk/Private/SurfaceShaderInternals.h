// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceShaderInternals_h
#define SurfaceShaderInternals_h

#include "vtkLimnSurfaceShader.h"

#include "Rendering/SurfaceShader.h"

/// The shader as the renderer calls it.
class vtkLimnSurfaceShader::vtkInternals : public limn::SurfaceShader
{
public:
  explicit vtkInternals(const vtkLimnSurfaceShader* self) : Self(self) {}

  void shade(const limn::SurfaceFragments& fragments, const limn::SurfaceLighting& lighting,
    limn::FragmentVectors& colors) const override;

private:
  const vtkLimnSurfaceShader* Self;
};

#endif
