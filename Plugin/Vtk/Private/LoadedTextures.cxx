// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LoadedTextures.h"

#include "EngineState.h"

#include "Rendering/Base/Power.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace limn::bridge
{
namespace
{

/// Opens what VTK keeps for its own textures.
struct OpenTexture : vtkTexture
{
  /// The array that the texture is to show.
  static vtkDataArray* scalarsOf(vtkTexture* texture, vtkImageData* input)
  {
    vtkDataArray* (vtkAlgorithm::*get)(int, vtkDataObject*) = &OpenTexture::GetInputArrayToProcess;
    return (texture->*get)(0, input);
  }
};

/// Numbers of colours, as TextureView has them.
struct Texels
{
  vtkDataArray* numbers;
  TexelFormat format;
  std::size_t bytes;
};

bool areColors(vtkTexture* texture, vtkDataArray* scalars)
{
  const int type = scalars->GetDataType();
  const int mode = texture->GetColorMode();
  const bool isDirect =
    (mode != VTK_COLOR_MODE_MAP_SCALARS && type == VTK_UNSIGNED_CHAR) ||
    (mode == VTK_COLOR_MODE_DIRECT_SCALARS && (type == VTK_UNSIGNED_SHORT || type == VTK_FLOAT));
  return isDirect && scalars->GetNumberOfComponents() >= 3;
}

Texels texelsOf(vtkTexture* texture, vtkDataArray* scalars)
{
  if (!areColors(texture, scalars))
  {
    // VTK maps through whatever the table holds.
    if (texture->GetLookupTable())
    {
      texture->GetLookupTable()->Build();
    }
    texture->MapScalarsToColors(scalars);
    scalars = texture->GetMappedScalars();
  }
  const auto count = static_cast<std::size_t>(scalars->GetNumberOfValues());
  switch (scalars->GetDataType())
  {
    case VTK_UNSIGNED_SHORT:
      return { scalars, TexelFormat::kUnorm16, 2 * count };
    case VTK_FLOAT:
      return { scalars, TexelFormat::kFloat32, 4 * count };
    default:
      return { scalars, TexelFormat::kUnorm8, count };
  }
}

/// Width and height: two of the image's dimensions. False if it has three.
bool findSize(vtkImageData* input, vtkDataArray* scalars, int (&size)[2])
{
  int dimensions[3];
  input->GetDimensions(dimensions);
  if (input->GetNumberOfCells() == scalars->GetNumberOfTuples())
  {
    for (int& side : dimensions)
    {
      side -= side > 1 ? 1 : 0;
    }
  }
  const int flat = dimensions[0] == 1 ? 0 : dimensions[1] == 1 ? 1 : 2;
  size[0] = dimensions[flat == 0 ? 1 : 0];
  size[1] = dimensions[flat == 2 ? 1 : 2];
  return dimensions[flat] <= 1;
}

template <class T>
bool hasLess(const T* numbers, std::size_t texels, T full)
{
  for (std::size_t i = 0; i < texels; ++i)
  {
    if (numbers[4 * i + 3] < full)
    {
      return true;
    }
  }
  return false;
}

bool letsThrough(const Texels& texels)
{
  const auto count = static_cast<std::size_t>(texels.numbers->GetNumberOfTuples());
  const void* const numbers = texels.numbers->GetVoidPointer(0);
  switch (texels.format)
  {
    case TexelFormat::kUnorm16:
      return hasLess(static_cast<const std::uint16_t*>(numbers), count, std::uint16_t{ 65535 });
    case TexelFormat::kFloat32:
      return hasLess(static_cast<const float*>(numbers), count, 1.0f);
    default:
      return hasLess(static_cast<const std::uint8_t*>(numbers), count, std::uint8_t{ 255 });
  }
}

/// The linear values that sRGB's bytes mean (IEC 61966-2-1), in 1/65535.
std::array<std::uint16_t, 256> makeLinear()
{
  std::array<std::uint16_t, 256> linear{};
  for (int byte = 0; byte < 256; ++byte)
  {
    const float encoded = static_cast<float>(byte) / 255.0f;
    const float value =
      encoded <= 0.04045f ? encoded / 12.92f : power((encoded + 0.055f) / 1.055f, 2.4f);
    linear[static_cast<std::size_t>(byte)] = static_cast<std::uint16_t>(value * 65535.0f + 0.5f);
  }
  return linear;
}

std::vector<std::uint16_t> decoded(const Texels& texels, int components)
{
  static const std::array<std::uint16_t, 256> linear = makeLinear();
  const auto* const bytes = static_cast<const std::uint8_t*>(texels.numbers->GetVoidPointer(0));
  std::vector<std::uint16_t> result(texels.bytes);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    const bool isAlpha = components == 4 && i % 4 == 3;
    result[i] = isAlpha ? static_cast<std::uint16_t>(257 * bytes[i]) : linear[bytes[i]];
  }
  return result;
}

/// As vtkOpenGLTexture reads the image.
Status load(vtkTexture* texture, vtkImageData* input, LoadedTexture& loaded)
{
  vtkDataArray* const scalars = OpenTexture::scalarsOf(texture, input);
  if (!scalars)
  {
    return { Error::kMissingData, "Its image has no scalars." };
  }
  int size[2];
  if (!findSize(input, scalars, size))
  {
    return { Error::kInvalidImageSize, "Its image is of three dimensions; give one slice of it." };
  }
  const Texels texels = texelsOf(texture, scalars);
  const int components = texels.numbers->GetNumberOfComponents();
  loaded.hasAlpha = components == 4;
  loaded.isOpaque = components != 4 || !letsThrough(texels);
  loaded.isFiltered =
    texture->GetInterpolate() && texture->GetMipmap() && std::max(size[0], size[1]) > 1;
  TextureView view;
  view.width = size[0];
  view.height = size[1];
  view.components = components;
  view.format = texels.format;
  view.texels = texels.numbers->GetVoidPointer(0);
  view.byteCount = texels.bytes;
  std::vector<std::uint16_t> linear;
  if (texture->GetUseSRGBColorSpace() && texels.format == TexelFormat::kUnorm8)
  {
    linear = decoded(texels, components);
    view.format = TexelFormat::kUnorm16;
    view.texels = linear.data();
    view.byteCount = 2 * linear.size();
  }
  return loaded.image.build(view, loaded.isFiltered ? MipChain::kFull : MipChain::kNone,
    EngineState::instance().options.threads);
}

/// One texture and when it was loaded.
class TextureSlot
{
public:
  const LoadedTexture& update(vtkTexture* texture)
  {
    vtkImageData* const input = updatedInput(texture);
    if (isUsed_ && timesOf(texture, input) == times_)
    {
      return loaded_;
    }
    isUsed_ = true;
    loaded_ = {};
    const Status status =
      input ? load(texture, input, loaded_) : Status{ Error::kMissingData, "It has no image." };
    // Mapping has made or changed the texture's own table.
    times_ = timesOf(texture, input);
    if (!status.ok())
    {
      vtkErrorWithObjectMacro(
        texture, "Surfaces are drawn without this texture. " << status.message);
    }
    return loaded_;
  }

private:
  using Times = std::array<vtkMTimeType, 3>;

  static vtkImageData* updatedInput(vtkTexture* texture)
  {
    vtkAlgorithm* const source = texture->GetInputAlgorithm();
    if (!source)
    {
      return nullptr;
    }
    texture->GetInputInformation()->Set(vtkStreamingDemandDrivenPipeline::EXACT_EXTENT(), 1);
    source->UpdateWholeExtent();
    return texture->GetInput();
  }

  static Times timesOf(vtkTexture* texture, vtkImageData* input)
  {
    vtkScalarsToColors* const table = texture->GetLookupTable();
    return { texture->GetMTime(), input ? input->GetMTime() : 0, table ? table->GetMTime() : 0 };
  }

  LoadedTexture loaded_;
  bool isUsed_ = false;
  Times times_{};
};

/// All textures in use. Never deleted: textures may outlive static objects.
class LoadedTextures
{
public:
  static LoadedTextures& instance()
  {
    static LoadedTextures* const all = new LoadedTextures;
    return *all;
  }

  TextureSlot& of(vtkTexture* texture)
  {
    std::unique_ptr<TextureSlot>& slot = slots_[texture];
    if (!slot)
    {
      slot = std::make_unique<TextureSlot>();
      texture->AddObserver(vtkCommand::DeleteEvent, this, &LoadedTextures::forget);
    }
    return *slot;
  }

private:
  void forget(vtkObject* texture, unsigned long, void*) { slots_.erase(texture); }

  std::unordered_map<vtkObject*, std::unique_ptr<TextureSlot>> slots_;
};

} // namespace

const LoadedTexture& loadedTextureOf(vtkTexture* texture)
{
  return LoadedTextures::instance().of(texture).update(texture);
}

} // namespace limn::bridge
