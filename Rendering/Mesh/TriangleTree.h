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

  /// When a box is looked into: after all that are looked into now, or not at all.
  enum class Turn { kNever, kNow, kLater };

  /// As visit(), of two halves of a box first the one for which isBefore(it, the other).
  /// turnOf(box) is asked when its turn comes, and of those for later again when only such are
  /// left. `later` is memory.
  template <class TurnOf, class IsBefore, class Visit>
  void visitInTurn(const TurnOf& turnOf, const IsBefore& isBefore, const Visit& visit,
                   std::vector<std::uint32_t>& later) const
  {
    later.clear();
    if (nodes_.empty()) return;
    std::uint32_t stack[kDeepest];
    int count = 0;
    stack[count++] = 0;
    bool isLast = false;
    while (count > 0 || !later.empty()) {
      if (count == 0) {
        isLast = true;
        stack[count++] = later.back();
        later.pop_back();
      }
      const std::uint32_t number = stack[--count];
      const Node& node = nodes_[number];
      const Turn turn = turnOf(node.box);
      if (turn == Turn::kNever) continue;
      if (turn == Turn::kLater && !isLast) {
        later.push_back(number);
      } else if (node.count == 0) {
        const bool isInOrder = isBefore(nodes_[node.first].box, nodes_[node.first + 1].box);
        stack[count++] = node.first + (isInOrder ? 1 : 0);
        stack[count++] = node.first + (isInOrder ? 0 : 1);
      } else {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
          visit(order_[i]);
      }
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
