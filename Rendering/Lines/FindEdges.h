// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/CompareNeighbours.h"
#include "Rendering/Lines/ImageOutline.h"
#include "Rendering/Lines/StepGrid.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

/// A piece of a surface's border or of a step, within about a pixel.
struct EdgePoint {
  Vec2f foot;    ///< where it is nearest to the pixel's centre; pixels
  Vec2f normal;  ///< unit, away from the surface; (0, 0): all of the pixel is at the border
  int column;
  std::uint32_t index;  ///< of the pixel
  std::uint32_t instance;
  bool isBent;  ///< where steps part it from pixels beside it, normals differ as at creases
};
/// Of one row of pixels, by columns.
struct EdgeRow {
  std::vector<EdgePoint> points;
};

/// Of which instances a crossing or a segment lies between pixels: the same twice unless they cut
/// each other there.
struct TwoSides {
  std::uint32_t first, second;

  bool has(std::uint32_t instance) const { return first == instance || second == instance; }
  bool isCut() const { return first != second; }
};
/// In any order.
inline bool areAlike(TwoSides a, TwoSides b)
{
  return (a.first == b.first && a.second == b.second) ||
         (a.first == b.second && a.second == b.first);
}

/// Where a crease, a border between ids, or the line along which two instances cut each other
/// crosses the way from a pixel to its right neighbour or the one above; borders of ids may be a
/// little aside of that.
struct CreaseCrossing {
  Vec2f place;
  int column;
  std::uint32_t index;   ///< of the pixel
  PixelPlace neighbour;  ///< that pixel
  TwoSides sides;
  bool isStep;  ///< and no crease, unless the step is a speck
  bool isBent;  ///< by normals alone, and not by ids or a cut
  float lean;   ///< of a cut: what share of its width the line is aside, to the instance that
                ///< comes first in the scene; -0.5 to 0.5
};
struct CreaseSegment {
  Vec2f from, to;  ///< may be one place
  int column;
  TwoSides sides;
  PixelPlace beside, beyond;  ///< pixels at its two sides
  float leanFrom, leanTo;     ///< CreaseCrossing::lean at its ends
  bool isWhole;               ///< a cut of which one side alone has a line, as wide as two halves
};
/// Crossings that leave a row of pixels, and segments between it and the row above.
struct CreaseRow {
  std::vector<CreaseCrossing> toRight, toAbove;  ///< by columns
  std::vector<CreaseSegment> segments;           ///< likewise
};

/// Finds edges between pixels that are next to each other.
class EdgeFinder {
 public:
  explicit EdgeFinder(const OutlinePass& pass);

  /// For NeighbourRows.
  const NeighbourBounds& bounds() const { return bounds_; }
  /// The edges that a row's pixels own, the crossings of creases that leave them, and what parts
  /// them from others: of the pixels that are marked, from the first touched on.
  void find(int y, const std::uint8_t* marks, EdgeRow& edges, CreaseRow& creases,
            StepGrid& steps) const;
  /// Whether there are instances without lines.
  bool hasBare() const
  {
    return std::any_of(settings_.begin(), settings_.end(),
                       [](const Settings& one) { return !one.isOutlined; });
  }
  /// Whether of two pixels next to each other, which show instances, the first's surface ends
  /// before the second's, or cuts it.
  bool endsAt(PixelPlace first, PixelPlace second) const
  {
    const Pixel one = pixelAt(first.x, first.y), other = pixelAt(second.x, second.y);
    return areCut(one, other) || isBefore(one, other);
  }

 private:
  struct Settings {
    bool isOutlined = false;
    OutlineDetector detector = OutlineDetector::kNone;
    CreaseDetector creases = CreaseDetector::kAngle;
    float creaseBound = 0;  ///< of 1 - n.n'
    bool hasIds = false;
  };
  struct Pixel {
    int x, y;
    std::size_t index;
    std::uint32_t instance;  ///< kNobody: no layer
    SurfacePatch layer;
  };

  Pixel pixelAt(int x, int y) const;
  bool isOutlined(std::uint32_t instance) const { return settings_[instance].isOutlined; }
  struct Neighbour {
    float share;   ///< that counts as the surface that the pixel shows: 1 for what lies before it
    bool isOther;  ///< another surface, or nobody
    bool isStep;   ///< of the pixel's instance, by its detector
    bool isCut;    ///< by another instance
  };
  Neighbour neighbourAt(const Pixel& pixel, int x, int y) const;
  float depthAt(int x, int y) const;
  bool isByPlanes(const Pixel& pixel) const
  {
    return settings_[pixel.instance].detector == OutlineDetector::kPlane;
  }
  bool isStep(const Pixel& first, const Pixel& second) const;
  bool isPlaneStep(const Pixel& first, const Pixel& second) const;
  bool isGroove(const Pixel& first, const Pixel& second, const PlaneDistances& distances) const;
  Vec3f towardEye(const SurfacePatch& first, const SurfacePatch& second) const;
  bool isSteeper(const SurfacePatch& first, const SurfacePatch& second) const;
  bool isConvolved(const Pixel& first, const Pixel& second) const;
  Vec2f sobel(const Pixel& pixel) const;
  float laplacian(const Pixel& pixel) const;
  float distanceBeside(const Pixel& pixel, int dx, int dy) const;
  bool isBent(const Pixel& first, const Pixel& second) const;
  Vec3f normalBeside(const Pixel& pixel, int dx, int dy) const;
  float gradientOfNormals(const Pixel& pixel) const;
  Vec3f laplacianOfNormals(const Pixel& pixel) const;
  bool isBefore(const Pixel& first, const Pixel& second) const;
  bool areCut(const Pixel& first, const Pixel& second) const;
  bool goesOn(const Pixel& pixel, const Pixel& next, Vec3f eye) const;
  bool isInstanceAt(int x, int y, std::uint32_t instance) const;
  float fall(const Pixel& pixel, Vec3f eye) const;
  float leanOfCut(const Pixel& first, const Pixel& second) const;
  Vec2f cutPlace(const Pixel& first, const Pixel& second) const;
  void addCuts(const Pixel& pixel, CreaseRow& creases) const;
  void addCut(const Pixel& pixel, int x, int y, std::vector<CreaseCrossing>& found) const;
  float tolerance(const Pixel& first, const Pixel& second) const;
  /// Of its samples, how many show its layer.
  float shareShown(const Pixel& pixel) const;
  float shareUpToBorder(const Pixel& pixel) const;
  float toleranceOf(const Pixel& pixel) const;
  void addEdge(const Pixel& pixel, EdgeRow& edges, CreaseRow& creases, StepGrid& steps) const;
  float wayToMeeting(const SurfacePatch& first, const SurfacePatch& second) const;
  Vec2f creasePlace(const SurfacePatch& first, const SurfacePatch& second) const;
  void addCrossing(const Pixel& pixel, int x, int y, std::vector<CreaseCrossing>& found) const;
  void look(PixelPlace place, unsigned marks, EdgeRow& edges, CreaseRow& creases,
            StepGrid& steps) const;

  const OutlinePass& pass_;
  const SurfaceLayers& layers_;
  float samples_;
  std::vector<Settings> settings_;  ///< by instance
  NeighbourBounds bounds_;
};

}  // namespace limn
