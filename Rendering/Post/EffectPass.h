// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Post/EffectPlanes.h"
#include "Rendering/Vertex/ThinLens.h"
#include "Rendering/Base/Executor.h"
#include "Rendering/Base/Vec.h"

#include <algorithm>
#include <cstddef>

namespace limn {

/// One picture on its way through the chain of effects, and the stages in their order. Each stage
/// reads what the one before it left in `planes` or the frame. All give the bytes of
/// Reference/ReferenceEffects, with any number of threads.
struct EffectPass {
  const PostEffects& effects;
  const FrameView& frame;
  EffectPlanes& planes;
  int threads;
};

/// Shares of red, green and blue in the luminance of tone mapping (Rec. 709).
inline constexpr Vec3f kLuminance = {0.2126f, 0.7152f, 0.0722f};

/// Calls body(y) once for each row of a plane, in any order, on several threads.
template <class Body>
void forEachRow(int threads, int height, const Body& body)
{
  constexpr int kRowsPerTask = 16;
  parallelFor(threads, static_cast<std::size_t>((height + kRowsPerTask - 1) / kRowsPerTask),
              [&](std::size_t task) {
                const int first = static_cast<int>(task) * kRowsPerTask;
                for (int y = first; y < std::min(first + kRowsPerTask, height); ++y)
                  body(y);
              });
}

/// FrameView::radiance times the exposure to `planes.image`.
void exposeRadiance(const EffectPass& pass);
/// Blurs `planes.image` and the frame's alpha.
void blurOutOfFocus(const EffectPass& pass, const ThinLens& lens);
/// Adds to `planes.image`.
void addBloom(const EffectPass& pass);
/// `planes.image` to the frame's red, green and blue.
void mapTones(const EffectPass& pass);
/// The frame's bytes to smooth ones; keeps alpha.
void smoothEdges(const EffectPass& pass);

}  // namespace limn
