// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/LocalPosition.h"
#include "Rendering/Mesh/WorldMesh.h"

#include <vector>

namespace limn {

/// Boxes about triangles of a WorldMesh and boxes about these, to find those that meet something.
/// The same tree on any machine.
class TriangleTree {
 public:
  /// Without the broken ones. `world` is borrowed.
  explicit TriangleTree(const WorldMesh& world);

  /// Calls visit(number) for each triangle of boxes for which meets(box) is true, in no order.
  template <class Meets, class Visit>
  void visit(const Meets& meets, const Visit& visit) const
  {
    if (nodes_.empty()) return;
    std::uint32_t stack[kDeepest];
    int count = 0;
    stack[count++] = 0;
    while (count > 0) {
      const Node& node = nodes_[stack[--count]];
      if (!meets(node.box)) continue;
      if (node.count == 0) {
        stack[count++] = node.first;
        stack[count++] = node.first + 1;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        visit(order_[i]);
    }
  }

 private:
  /// Halves of halves: more than there can be triangles.
  static constexpr int kDeepest = 80;
  static constexpr std::uint32_t kLeaf = 4;

  struct Node {
    Box box;
    std::uint32_t first;  ///< of two nodes, or of `count` triangles
    std::uint32_t count;
  };
  void split(const WorldMesh& world, std::uint32_t node, std::uint32_t first, std::uint32_t end);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace limn
