// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/CountNonManifold.h"

#include <hwy/cache_control.h>

namespace limn::meshio {
namespace {

/// A set of directed edges, open addressing; at most half full, so that probes stay short.
class EdgeSet {
 public:
  explicit EdgeSet(std::size_t mostEdges)
  {
    while ((std::size_t{1} << bits_) < 2 * mostEdges)
      ++bits_;
    slots_.assign(std::size_t{1} << bits_, kEmpty);
  }

  /// To be called some time before the edge is asked for, as slots lie at random.
  void prefetch(std::uint32_t from, std::uint32_t to) const
  {
    hwy::Prefetch(&slots_[firstSlotOf(keyOf(from, to))]);
  }
  bool contains(std::uint32_t from, std::uint32_t to) const
  {
    return slots_[slotOf(keyOf(from, to))] != kEmpty;
  }
  void insert(std::uint32_t from, std::uint32_t to)
  {
    const std::uint64_t key = keyOf(from, to);
    slots_[slotOf(key)] = key;
  }

 private:
  /// An edge from a vertex to itself, which is never asked for.
  static constexpr std::uint64_t kEmpty = 0;

  static std::uint64_t keyOf(std::uint32_t from, std::uint32_t to)
  {
    return std::uint64_t{from} << 32 | to;
  }

  std::size_t firstSlotOf(std::uint64_t key) const
  {
    constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(key * kGoldenRatio >> (64 - bits_));
  }
  /// Where the key is, or where it belongs.
  std::size_t slotOf(std::uint64_t key) const
  {
    std::size_t slot = firstSlotOf(key);
    while (slots_[slot] != kEmpty && slots_[slot] != key)
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  unsigned bits_ = 1;
  std::vector<std::uint64_t> slots_;
};

/// Calls visit(from, to) for the edges of a face until it returns false; returns whether it did
/// not.
template <class Visit>
bool forEachEdge(const RawMesh& mesh, std::size_t face, Visit&& visit)
{
  const std::size_t begin = static_cast<std::size_t>(mesh.offsets[face]);
  const std::size_t end = static_cast<std::size_t>(mesh.offsets[face + 1]);
  std::uint32_t from = mesh.corners[end - 1];
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t to = mesh.corners[i];
    if (from != to && !visit(from, to)) return false;
    from = to;
  }
  return true;
}

}  // namespace

std::size_t countNonManifoldFaces(const RawMesh& mesh)
{
  constexpr std::size_t kAhead = 8;
  EdgeSet edges(mesh.corners.size());
  std::size_t count = 0;
  for (std::size_t face = 0; face < mesh.faceCount(); ++face) {
    if (face + kAhead < mesh.faceCount())
      forEachEdge(mesh, face + kAhead, [&edges](std::uint32_t from, std::uint32_t to) {
        edges.prefetch(from, to);
        return true;
      });
    const bool fits = forEachEdge(mesh, face, [&edges](std::uint32_t from, std::uint32_t to) {
      return !edges.contains(from, to);
    });
    if (!fits) {
      ++count;
      continue;
    }
    forEachEdge(mesh, face, [&edges](std::uint32_t from, std::uint32_t to) {
      edges.insert(from, to);
      return true;
    });
  }
  return count;
}

}  // namespace limn::meshio
