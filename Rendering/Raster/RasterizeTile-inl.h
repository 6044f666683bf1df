// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by RasterizeTile.cpp.
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A box of whole pixels, last ones included.
struct PixelBox {
  int x0, y0, x1, y1;

  bool empty() const { return x0 > x1 || y0 > y1; }
};

/// Triangles whose box is smaller than this many subpixels in x and y have edge functions that fit
/// 32 bits everywhere in their box and up to 16 pixels beside it.
constexpr std::int32_t kSmallBox = 64 * kSubpixels;
static_assert(std::int64_t{kSmallBox} * (kSmallBox + 17 * kSubpixels) * 2 < (std::int64_t{1} << 30),
              "edge values of small triangles fit int32");

/// One tile being drawn.
struct TileTarget {
  const TileClusters& clusters;
  TileRectangle pixels;
  Span<const SampleOffset> offsets;
  SampleOffset lowest, highest;  ///< over all samples, per axis
  VisibilityTile& tile;

  PixelBox box(std::int32_t minX, std::int32_t minY, std::int32_t maxX, std::int32_t maxY) const
  {
    return {std::max(pixels.x0, (minX - highest.x + kSubpixels - 1) >> kSubpixelBits),
            std::max(pixels.y0, (minY - highest.y + kSubpixels - 1) >> kSubpixelBits),
            std::min(pixels.x1 - 1, (maxX - lowest.x) >> kSubpixelBits),
            std::min(pixels.y1 - 1, (maxY - lowest.y) >> kSubpixelBits)};
  }
};

/// The depth plane of a triangle over its edge values: z0 + (e1 z1 + e2 z2).
struct DepthPlane {
  float z0, z1, z2;

  DepthPlane(float depth0, float depth1, float depth2, float area)
  {
    const float inverse = 1.0f / area;
    z0 = depth0;
    z1 = (depth1 - depth0) * inverse;
    z2 = (depth2 - depth0) * inverse;
  }
};

/// Gives the covered samples of one vector of pixels to `owner` where it is the nearest.
template <class D, class V, class M>
HWY_INLINE void depthTest(D d, const TileTarget& target, std::size_t sample, std::size_t index,
                          M covered, V depth, std::uint32_t owner)
{
  const hn::RebindToUnsigned<D> du;
  float* depths = target.tile.depth[sample] + index;
  std::uint32_t* owners = target.tile.owner[sample] + index;
  const V zero = hn::Zero(d);
  const V z = hn::IfThenElse(hn::Gt(depth, zero), depth, zero);
  const V old = hn::Load(d, depths);
  const auto visible = hn::And(covered, hn::Le(depth, hn::Set(d, 1.0f)));
  auto nearer = hn::And(visible, hn::Lt(z, old));
  const auto equal = hn::And(visible, hn::Eq(z, old));
  if (!hn::AllFalse(d, equal)) {
    float wins[HWY_MAX_BYTES / sizeof(float)];
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
      wins[lane] = target.clusters.drawnLater(owner, owners[lane]) ? 1.0f : 0.0f;
    nearer = hn::Or(nearer, hn::And(equal, hn::Gt(hn::LoadU(d, wins), zero)));
  }
  hn::Store(hn::IfThenElse(nearer, z, old), d, depths);
  const auto oldOwner = hn::Load(du, owners);
  hn::Store(hn::IfThenElse(hn::RebindMask(du, nearer), hn::Set(du, owner), oldOwner), du, owners);
}

/// Any triangle, with edge values in double: they stay below 2^50, so every step is exact.
void drawLarge(const OrientedTriangle& triangle, std::uint32_t owner, const TileTarget& target)
{
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, decltype(d)> df;
  const auto& c = triangle.corner;
  const PixelBox box =
      target.box(std::min({c[0].x, c[1].x, c[2].x}), std::min({c[0].y, c[1].y, c[2].y}),
                 std::max({c[0].x, c[1].x, c[2].x}), std::max({c[0].y, c[1].y, c[2].y}));
  if (box.empty()) return;
  const DepthPlane plane(c[0].depth, c[1].depth, c[2].depth, static_cast<float>(triangle.area));
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int firstX = box.x0 - (box.x0 - target.pixels.x0) % lanes;
  const auto laneOffset = hn::Iota(d, 0.0);
  for (std::size_t s = 0; s < target.offsets.size(); ++s)
    for (int y = box.y0; y <= box.y1; ++y)
      for (int x = firstX; x <= box.x1; x += lanes) {
        const std::int64_t px = std::int64_t{x} * kSubpixels + target.offsets[s].x;
        const std::int64_t py = std::int64_t{y} * kSubpixels + target.offsets[s].y;
        const auto edgeAt = [&](int i) HWY_ATTR {
          const EdgeFunction& e = triangle.edge[i];
          return hn::Add(hn::Set(d, static_cast<double>(e.at(px, py))),
                         hn::Mul(laneOffset, hn::Set(d, static_cast<double>(e.a * kSubpixels))));
        };
        const auto e0 = edgeAt(0), e1 = edgeAt(1), e2 = edgeAt(2);
        const auto inside = [&](int i, decltype(e0) e) HWY_ATTR {
          const auto least = hn::Set(d, static_cast<double>(triangle.edge[i].smallestInside));
          // Rounding to float keeps the sign.
          return hn::Ge(hn::DemoteTo(df, hn::Sub(e, least)), hn::Zero(df));
        };
        const auto covered = hn::And(inside(0, e0), hn::And(inside(1, e1), inside(2, e2)));
        if (hn::AllFalse(df, covered)) continue;
        const auto z = hn::Add(hn::Set(df, plane.z0),
                               hn::Add(hn::Mul(hn::DemoteTo(df, e1), hn::Set(df, plane.z1)),
                                       hn::Mul(hn::DemoteTo(df, e2), hn::Set(df, plane.z2))));
        const auto index =
            static_cast<std::size_t>((y - target.pixels.y0) * kTileSide + (x - target.pixels.x0));
        depthTest(df, target, s, index, covered, z, owner);
      }
}

/// A triangle with a box below kSmallBox, with edge values in int32. `i1`, `i2` are the second and
/// third corner, counter-clockwise.
HWY_INLINE void drawSmall(const ScreenVertices& screen, std::uint32_t i0, std::uint32_t i1,
                          std::uint32_t i2, std::uint32_t owner, const TileTarget& target)
{
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const std::int32_t x[3] = {screen.x[i0], screen.x[i1], screen.x[i2]};
  const std::int32_t y[3] = {screen.y[i0], screen.y[i1], screen.y[i2]};
  const PixelBox box = target.box(std::min({x[0], x[1], x[2]}), std::min({y[0], y[1], y[2]}),
                                  std::max({x[0], x[1], x[2]}), std::max({y[0], y[1], y[2]}));
  if (box.empty()) return;
  const std::int32_t area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  const DepthPlane plane(screen.depth[i0], screen.depth[i1], screen.depth[i2],
                         static_cast<float>(area));

  const int lanes = static_cast<int>(hn::Lanes(d));
  const int firstX = box.x0 - (box.x0 - target.pixels.x0) % lanes;
  std::int32_t stepX[3], stepY[3], least[3], start[3];
  for (int i = 0; i < 3; ++i) {
    const int from = (i + 1) % 3, to = (i + 2) % 3;
    const std::int32_t dx = x[to] - x[from], dy = y[to] - y[from];
    stepX[i] = -dy * kSubpixels;
    stepY[i] = dx * kSubpixels;
    least[i] = dy < 0 || (dy == 0 && dx < 0) ? 0 : 1;
    start[i] = dx * (box.y0 * kSubpixels - y[from]) - dy * (firstX * kSubpixels - x[from]);
  }
  const auto ramp = hn::Iota(di, 0);
  for (std::size_t s = 0; s < target.offsets.size(); ++s) {
    const SampleOffset offset = target.offsets[s];
    for (int row = box.y0; row <= box.y1; ++row)
      for (int column = firstX; column <= box.x1; column += lanes) {
        const auto edgeAt = [&](int i) HWY_ATTR {
          const std::int32_t here =
              start[i] + stepY[i] * (row - box.y0) + stepX[i] * (column - firstX) +
              (stepX[i] / kSubpixels) * offset.x + (stepY[i] / kSubpixels) * offset.y;
          return hn::Add(hn::Set(di, here), hn::Mul(ramp, hn::Set(di, stepX[i])));
        };
        const auto e0 = edgeAt(0), e1 = edgeAt(1), e2 = edgeAt(2);
        const auto under =
            hn::Or(hn::Sub(e0, hn::Set(di, least[0])),
                   hn::Or(hn::Sub(e1, hn::Set(di, least[1])), hn::Sub(e2, hn::Set(di, least[2]))));
        const auto covered = hn::RebindMask(d, hn::Gt(under, hn::Set(di, -1)));
        if (hn::AllFalse(d, covered)) continue;
        const auto z = hn::Add(hn::Set(d, plane.z0),
                               hn::Add(hn::Mul(hn::ConvertTo(d, e1), hn::Set(d, plane.z1)),
                                       hn::Mul(hn::ConvertTo(d, e2), hn::Set(d, plane.z2))));
        const auto index = static_cast<std::size_t>((row - target.pixels.y0) * kTileSide +
                                                    (column - target.pixels.x0));
        depthTest(d, target, s, index, covered, z, owner);
      }
  }
}

/// Draws one triangle by the general way: clipped pieces, or a box too large for int32.
void drawGeneral(const PlacedCluster& cluster, const ScreenVertices& screen, std::uint32_t triangle,
                 std::uint32_t owner, const TileTarget& target)
{
  const Instance& instance = *cluster.placed->instance;
  const auto drawPiece = [&](const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
    OrientedTriangle oriented;
    if (!orient(a, b, c, oriented)) return;
    if (oriented.clockwise ? instance.cullBackFaces : instance.cullFrontFaces) return;
    drawLarge(oriented, owner, target);
  };
  const ScreenVertex corner[3] = {screen.vertex(cluster.corner(triangle, 0)),
                                  screen.vertex(cluster.corner(triangle, 1)),
                                  screen.vertex(cluster.corner(triangle, 2))};
  if (!corner[0].needsClip && !corner[1].needsClip && !corner[2].needsClip) {
    drawPiece(corner[0], corner[1], corner[2]);
    return;
  }
  const ClippedTriangle polygon = clipClusterTriangle(cluster, triangle, screen);
  for (int i = 1; i + 1 < polygon.count; ++i)
    drawPiece(polygon.vertex[0], polygon.vertex[i], polygon.vertex[i + 1]);
}

/// Sets up a vector of triangles at once, drops those that cover no sample of the tile, and draws
/// the rest.
void drawCluster(const PlacedCluster& cluster, std::uint32_t slot, const TileTarget& target)
{
  const hn::ScalableTag<std::int32_t> d;
  const hn::Rebind<std::uint8_t, decltype(d)> d8;
  ScreenVertices screen;
  transformVertices(cluster, screen);

  const Instance& instance = *cluster.placed->instance;
  const ClusteredMesh& mesh = cluster.mesh();
  const std::size_t first = cluster.cluster->firstTriangle;
  const std::size_t count = cluster.cluster->triangleCount;
  // The spare corners behind the last triangle are real vertex numbers of some cluster, below 64.
  const auto corner = [&](int k, std::size_t t) HWY_ATTR {
    return hn::PromoteTo(d, hn::LoadU(d8, mesh.corner[k].data() + first + t));
  };
  const auto smaller = [&](auto a, auto b) HWY_ATTR { return hn::IfThenElse(hn::Lt(a, b), a, b); };
  const auto larger = [&](auto a, auto b) HWY_ATTR { return hn::IfThenElse(hn::Gt(a, b), a, b); };

  for (std::size_t t = 0; t < count; t += hn::Lanes(d)) {
    const auto i0 = corner(0, t), i1 = corner(1, t), i2 = corner(2, t);
    const auto x0 = hn::GatherIndex(d, screen.x, i0), y0 = hn::GatherIndex(d, screen.y, i0);
    const auto x1 = hn::GatherIndex(d, screen.x, i1), y1 = hn::GatherIndex(d, screen.y, i1);
    const auto x2 = hn::GatherIndex(d, screen.x, i2), y2 = hn::GatherIndex(d, screen.y, i2);
    const auto clip = hn::Or(
        hn::GatherIndex(d, screen.needsClip, i0),
        hn::Or(hn::GatherIndex(d, screen.needsClip, i1), hn::GatherIndex(d, screen.needsClip, i2)));
    const auto minX = smaller(x0, smaller(x1, x2)), maxX = larger(x0, larger(x1, x2));
    const auto minY = smaller(y0, smaller(y1, y2)), maxY = larger(y0, larger(y1, y2));

    // Pixels with a sample between the borders; the box of a small triangle or sliver often has
    // none.
    const auto firstPixel = [&](auto low, std::int32_t offset, int border) HWY_ATTR {
      const auto p =
          hn::ShiftRight<kSubpixelBits>(hn::Add(low, hn::Set(d, kSubpixels - 1 - offset)));
      return larger(p, hn::Set(d, border));
    };
    const auto lastPixel = [&](auto high, std::int32_t offset, int border) HWY_ATTR {
      const auto p = hn::ShiftRight<kSubpixelBits>(hn::Sub(high, hn::Set(d, offset)));
      return smaller(p, hn::Set(d, border));
    };
    const auto missX = hn::Gt(firstPixel(minX, target.highest.x, target.pixels.x0),
                              lastPixel(maxX, target.lowest.x, target.pixels.x1 - 1));
    const auto missY = hn::Gt(firstPixel(minY, target.highest.y, target.pixels.y0),
                              lastPixel(maxY, target.lowest.y, target.pixels.y1 - 1));

    const auto width = hn::Sub(maxX, minX), height = hn::Sub(maxY, minY);
    const auto small =
        hn::And(hn::Lt(width, hn::Set(d, kSmallBox)), hn::Lt(height, hn::Set(d, kSmallBox)));
    // Wraps around for large triangles, which are not asked.
    const auto area = hn::Sub(hn::Mul(hn::Sub(x1, x0), hn::Sub(y2, y0)),
                              hn::Mul(hn::Sub(x2, x0), hn::Sub(y1, y0)));
    const auto clockwise = hn::Lt(area, hn::Zero(d));
    auto drawn = hn::Ne(area, hn::Zero(d));
    if (instance.cullBackFaces) drawn = hn::And(drawn, hn::Not(clockwise));
    if (instance.cullFrontFaces) drawn = hn::And(drawn, clockwise);
    const auto general = hn::Or(hn::Not(small), hn::Ne(clip, hn::Zero(d)));
    const auto missed = hn::And(hn::Or(missX, missY), hn::Eq(clip, hn::Zero(d)));
    const auto kept = hn::And(hn::Or(drawn, general), hn::Not(missed));
    if (hn::AllFalse(d, kept)) continue;

    std::uint8_t keptBits[8] = {}, generalBits[8] = {}, clockwiseBits[8] = {};
    hn::StoreMaskBits(d, kept, keptBits);
    hn::StoreMaskBits(d, general, generalBits);
    hn::StoreMaskBits(d, clockwise, clockwiseBits);
    const auto bit = [](const std::uint8_t* bits, std::size_t lane) {
      return (bits[lane / 8] >> (lane % 8) & 1) != 0;
    };
    for (std::size_t lane = 0; lane < hn::Lanes(d) && t + lane < count; ++lane) {
      if (!bit(keptBits, lane)) continue;
      const auto triangle = static_cast<std::uint32_t>(t + lane);
      const std::uint32_t owner = TileOwner::make(slot, triangle);
      if (bit(generalBits, lane)) {
        drawGeneral(cluster, screen, triangle, owner, target);
        continue;
      }
      const std::uint32_t c0 = cluster.corner(triangle, 0), c1 = cluster.corner(triangle, 1),
                          c2 = cluster.corner(triangle, 2);
      if (bit(clockwiseBits, lane))
        drawSmall(screen, c0, c2, c1, owner, target);
      else
        drawSmall(screen, c0, c1, c2, owner, target);
    }
  }
}

void rasterizeTileKernel(const TileClusters& clusters, const TileRectangle& pixels, int samples,
                         VisibilityTile& tile)
{
  const Span<const SampleOffset> offsets = samplePositions(samples);
  SampleOffset lowest = offsets[0], highest = offsets[0];
  for (const SampleOffset& offset : offsets) {
    lowest = {std::min(lowest.x, offset.x), std::min(lowest.y, offset.y)};
    highest = {std::max(highest.x, offset.x), std::max(highest.y, offset.y)};
  }
  const TileTarget target = {clusters, pixels, offsets, lowest, highest, tile};
  for (std::uint32_t slot = 0; slot < clusters.list.size(); ++slot)
    drawCluster(clusters.at(slot), slot, target);
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
