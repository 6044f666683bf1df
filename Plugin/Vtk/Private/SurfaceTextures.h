// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceTextures_h
#define SurfaceTextures_h

#include "VectorArray.h"

#include "Rendering/Base/Status.h"
#include "Rendering/Scene.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkImageData;
class vtkLimnPolyDataMapper;
class vtkPolyData;

namespace limn::bridge
{

class Complaints;

/// The colours that a mapper looks its scalars up in after it has interpolated them, loaded anew
/// when they change.
class ColorTable
{
public:
  /// Errors: those of TextureImage::build().
  Status update(vtkImageData* colors);
  const TextureImage& image() const { return this->image_; }

private:
  vtkSmartPointer<vtkImageData> colors_;
  vtkMTimeType time_ = 0;
  Status status_;
  TextureImage image_;
};

/// What of textures one mapper keeps of its input between frames.
struct MapperTextures
{
  TCoordArray active;                       ///< the input's texture coordinates
  std::map<std::string, TCoordArray> named; ///< point arrays that textures read instead
  TCoordArray scalars;                      ///< where `colors` is to be read, by points
  ColorTable colors;
  std::string complaint; ///< what was said last
};

/// The textures of the surfaces of one frame; their instances borrow from it.
class FrameTextures
{
public:
  /// Puts the textures of `actor`, its property and the mapper's scalars over `instance`. What
  /// cannot be drawn, for lack of texture coordinates, is said once as a complaint of the mapper.
  /// Requires: `instance` has its style and all other attributes.
  void apply(vtkActor* actor, vtkLimnPolyDataMapper* mapper, vtkPolyData* data, Instance& instance,
    Complaints& complaints);

private:
  struct Layers
  {
    std::vector<TextureLayer> list;
    ProceduralTexture procedural;
  };

  std::vector<std::unique_ptr<Layers>> layers_; ///< of instances that have any
};

/// Whether the mapper interpolates scalars, not their colours, for an instance of that frequency.
bool interpolatesScalars(
  vtkLimnPolyDataMapper* mapper, vtkPolyData* data, ShadingFrequency frequency);

} // namespace limn::bridge

#endif
