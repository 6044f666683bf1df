// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/CheckEffects.h"

#include "Rendering/Vertex/ThinLens.h"

#include <cmath>

namespace limn {
namespace {

bool isFrom(float low, float value, float high)
{
  return value >= low && value <= high;  // false for what is not a number
}

Status refuse(const char* what)
{
  return {Error::kNotFinite, what};
}

Status checkLens(const DepthOfField& lens, const Camera& camera)
{
  if (!std::isfinite(lens.aperture) || lens.aperture < 0)
    return refuse("The aperture is not a finite number of at least 0.");
  if (lens.aperture == 0) return {};
  if (!std::isfinite(lens.focusDistance) || lens.focusDistance <= 0)
    return refuse("The focus distance is not a finite number greater than 0.");
  if (lens.maxRadius < 1 || lens.maxRadius > kMaxBlurRadius)
    return refuse("The largest radius of blur is not from 1 to 63 pixels.");
  if (!hasLens(camera))
    return {Error::kMissingData,
            "Depth of field needs a perspective camera; with this one set the aperture to 0."};
  const ThinLens thin = thinLens(lens, camera, kMaxImageSide);
  if (!std::isfinite(thin.slope) || !std::isfinite(thin.offset))
    return refuse("The aperture is too large for the focus distance.");
  return {};
}

Status checkFxaa(const Fxaa& fxaa)
{
  for (const float threshold : {fxaa.relativeContrastThreshold, fxaa.hardContrastThreshold,
                                fxaa.subpixelBlendLimit, fxaa.subpixelContrastThreshold})
    if (!isFrom(0, threshold, 1))
      return refuse("A contrast threshold or blend limit of FXAA is not from 0 to 1.");
  if (fxaa.endpointSearchIterations < 0 || fxaa.endpointSearchIterations > kMaxImageSide)
    return refuse("The endpoint search iterations of FXAA are not from 0 to 16384.");
  return {};
}

}  // namespace

Status checkEffects(const PostEffects& effects, const Camera& camera, const FrameView& frame)
{
  if (!std::isfinite(effects.exposure) || effects.exposure < 0)
    return refuse("The exposure is not a finite number of at least 0.");
  if (!isFrom(0.001f, effects.whitePoint, kMaxRadiance))
    return refuse("The white point of tone mapping is not from 0.001 to 65504.");
  const Bloom& bloom = effects.bloom;
  if (!isFrom(0, bloom.strength, kMaxRadiance) || !isFrom(0, bloom.threshold, kMaxRadiance))
    return refuse("The strength or the threshold of the bloom is not from 0 to 65504.");
  if (bloom.levels < 1 || bloom.levels > kMaxBloomLevels)
    return refuse("The levels of the bloom are not from 1 to 8.");
  if (Status status = checkLens(effects.depthOfField, camera); !status.ok()) return status;
  if (Status status = checkFxaa(effects.fxaa); !status.ok()) return status;
  if (frame.width < 1 || frame.height < 1 || frame.width > kMaxImageSide ||
      frame.height > kMaxImageSide || frame.rowStride < frame.width)
    return {Error::kInvalidImageSize, "Post effects need an image of 1 to 16384 pixels a side."};
  if (frame.color == nullptr || frame.depth == nullptr)
    return {Error::kMissingData, "The image has no colour or no depth plane."};
  const RadianceView& radiance = frame.radiance;
  if (effects.needRadiance() &&
      (radiance.r == nullptr || radiance.g == nullptr || radiance.b == nullptr))
    return {Error::kMissingData, "These post effects need planes of radiance in the frame."};
  return {};
}

}  // namespace limn
