// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Status.h"
#include "Rendering/FrameView.h"
#include "Rendering/Optimizations.h"
#include "Rendering/PostEffects.h"
#include "Rendering/Scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace limn {

enum class Backend : std::uint8_t {
  kPipeline,   ///< clusters, tiles, vector kernels, all cores; reads Instance::clusters
  kReference,  ///< plain scalar code, one thread; reads Instance::mesh; the same bytes
};

struct RenderOptions {
  Backend backend = Backend::kPipeline;
  int threads = 0;  ///< 0: all; the picture does not depend on it
  Optimizations optimizations = {};
};

/// What one frame did. Times are wall-clock milliseconds.
struct RenderStats {
  std::size_t instances = 0, clusters = 0, triangles = 0, vertices = 0;
  std::size_t binnedClusters = 0;    ///< cluster-tile pairs after culling
  std::size_t occludedClusters = 0;  ///< of these, left out because the tile was nearer
  /// Pixels with more translucent surfaces than were kept; see kMaxTranslucentSamples.
  std::size_t truncatedPixels = 0;
  double binMilliseconds = 0, tileMilliseconds = 0;
  std::size_t bytes = 0;   ///< of the clusters and of the frame's own memory
  PixelRectangle touched;  ///< no pixel outside was written, but for FrameView::clear
};

/// Draws `scene` into `frame`. The picture depends on the scene and the frame's old content only:
/// not on the backend, the threads, the instruction set or earlier calls. Errors:
/// kInvalidImageSize, kInvalidSampleCount, kInvalidLight, kNotFinite (a matrix, light or material),
/// kSizeMismatch, kMissingData, kTooManyPrimitives. On an error nothing is drawn.
Status render(const Scene& scene, const FrameView& frame, const RenderOptions& options = {},
              RenderStats* stats = nullptr);

class EffectPlanes;  // Rendering/Post/EffectPlanes.h

/// Does what `effects` ask for to the colours of a finished picture: of its surfaces, whatever
/// number of render() calls drew them, and its background. `frame.radiance` is required where
/// PostEffects::needRadiance() says so, and to have been in the frame when the surfaces were drawn;
/// `camera` gives depths their distances. The picture depends on nothing else, as render()'s.
/// Errors, on which nothing is changed: kNotFinite (a setting is out of its range),
/// kInvalidImageSize, kMissingData.
Status applyEffects(const PostEffects& effects, const Camera& camera, const FrameView& frame,
                    EffectPlanes& planes, const RenderOptions& options = {});

/// Names of the instruction sets that the kernels are built for and this CPU has, best first
/// ("AVX3", "AVX2", "SSE4", "SSSE3"; "NEON" on AArch64).
std::vector<std::string> availableTargets();
/// Makes all kernels use one of availableTargets(), or the best again for "". False if unknown. For
/// tests and developers; not while another thread renders.
bool useTarget(const std::string& name);
/// The instruction set in use.
std::string currentTarget();

}  // namespace limn
