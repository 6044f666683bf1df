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
  std::uint32_t index;     ///< of the pixel
  std::uint32_t instance;  ///< whose surface it is
  PixelPlace shown;        ///< that pixel, or one next to it that shows the surface
  float part;              ///< of the line's width that is drawn on the surface
  bool isBent;          ///< where steps part it from pixels beside it, normals differ as at creases
  bool isBesideHidden;  ///< next to its pixel something hides where the surface may go on
};
/// Of one row of pixels, by columns; a pixel may have several.
struct EdgeRow {
  std::vector<EdgePoint> points;
};

/// Where a crease or a border between ids crosses the way from a pixel to its right neighbour or
/// the one above; borders of ids may be a little aside of that.
struct CreaseCrossing {
  Vec2f place;
  int column;
  std::uint32_t index;   ///< of the pixel
  PixelPlace neighbour;  ///< that pixel
  std::uint32_t instance;
  bool isStep;  ///< and no crease, unless the step is a speck
  bool isBent;  ///< by normals alone, and not by ids
};
struct CreaseSegment {
  Vec2f from, to;  ///< may be one place
  int column;
  std::uint32_t instance;
  PixelPlace beside, beyond;  ///< pixels at its two sides
};
/// Crossings that leave a row of pixels, and segments between it and the row above.
struct CreaseRow {
  std::vector<CreaseCrossing> toRight, toAbove;  ///< by columns
  std::vector<CreaseSegment> segments;           ///< likewise
};

/// One element for each row of the layers, those of the apron included.
template <class Row>
class LayerRows {
 public:
  void begin(const SurfaceLayers& layers)
  {
    first_ = -layers.apron;
    rows_.resize(static_cast<std::size_t>(layers.endY() - first_));
  }
  int first() const { return first_; }
  int end() const { return first_ + static_cast<int>(rows_.size()); }
  Row& operator[](int y) { return rows_[static_cast<std::size_t>(y - first_)]; }
  const Row& operator[](int y) const { return rows_[static_cast<std::size_t>(y - first_)]; }
  /// From below.
  std::vector<Row>& all() { return rows_; }
  const std::vector<Row>& all() const { return rows_; }

 private:
  int first_ = 0;
  std::vector<Row> rows_;
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
  /// Of two pixels next to each other, which show instances: whether the first's surface ends
  /// before the second's, cuts it, or ends behind it.
  enum class Order : std::uint8_t { kBefore, kCut, kBehind };
  Order orderOf(PixelPlace first, PixelPlace second) const
  {
    const Pixel one = pixelAt(first.x, first.y), other = pixelAt(second.x, second.y);
    if (one.instance == other.instance)
      return isBefore(one, other) ? Order::kBefore : Order::kBehind;
    const float lean = leanOf(one, other);
    return isCutBy(lean) ? Order::kCut : lean > 0.0f ? Order::kBefore : Order::kBehind;
  }

  /// Where a crease ends that leaves the square into which it goes by (x, y) from its crossing
  /// over none of the other sides: behind what hides it there; else it ends at the crossing.
  Vec2f endBehind(const CreaseCrossing& crossing, PixelPlace inwards) const;

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
    float share;     ///< that counts as the surface that the pixel shows: 1 for what lies before it
    bool isOther;    ///< another surface, or nobody
    bool isForeign;  ///< another instance
    bool isStep;     ///< of the pixel's instance, by its detector
    bool isCut;      ///< by another instance
    float part;  ///< of the line's width on the pixel's side: 0 where its surface goes on, or ends
                 ///< behind another's
    float lean;  ///< of another instance: leanOf()
    bool isHiding;  ///< the pixel's surface may go on behind it, or where the layers end
  };
  Neighbour neighbourAt(const Pixel& pixel, int x, int y) const;
  float shareBeyond(const Pixel& pixel, const Pixel& other) const;
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
  float gapBetween(const Pixel& first, const Pixel& second) const;
  float leanOf(const Pixel& first, const Pixel& second) const;
  static bool isCutBy(float lean) { return lean > -0.5f && lean < 0.5f; }
  float partOf(const Pixel& beyond, float lean) const;
  bool isInstanceAt(int x, int y, std::uint32_t instance) const;
  float nearness(const Pixel& pixel, Vec3f eye) const;
  float fall(const Pixel& pixel, Vec3f eye) const;
  Vec2f cutPlace(const Pixel& first, const Pixel& second) const;
  float tolerance(const Pixel& first, const Pixel& second) const;
  /// Of its samples, how many show its layer.
  float shareShown(const Pixel& pixel) const;
  float toleranceOf(const Pixel& pixel) const;
  struct Around;
  void addEdges(const Pixel& pixel, EdgeRow& edges, StepGrid& steps) const;
  void addWhole(const Around& around, EdgePoint edge, EdgeRow& edges) const;
  float shiftOf(const EdgePoint& edge, const Pixel& pixel, const Pixel& beyond, float lean) const;
  void addParts(const Around& around, EdgePoint edge, EdgeRow& edges) const;
  float wayToMeeting(const SurfacePatch& first, const SurfacePatch& second) const;
  Vec2f creasePlace(const SurfacePatch& first, const SurfacePatch& second) const;
  Vec3f planeOnScreen(const SurfacePatch& patch) const;
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
