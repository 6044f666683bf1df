// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by RasterizeTile.cpp.
#include "Rendering/Base/Compress-inl.h"
#include "Rendering/Base/Gather-inl.h"
#include "Rendering/Base/MaskBits-inl.h"
#include "Rendering/Base/Simd.h"
#include "Rendering/Raster/EdgesOfRow-inl.h"
#include "Rendering/Vertex/ScreenLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::int32_t kMaxLanes = HWY_MAX_BYTES / sizeof(std::int32_t);

/// A box of whole pixels, last ones included.
struct PixelBox {
  int x0, y0, x1, y1;

  bool empty() const { return x0 > x1 || y0 > y1; }
};

/// Triangles whose box is smaller than this many subpixels in x and y have edge functions that fit
/// 32 bits everywhere in their box and up to 16 pixels beside it.
constexpr std::int32_t kSmallBox = 112 * kSubpixels;
static_assert(std::int64_t{kSmallBox} * (kSmallBox + 17 * kSubpixels) * 2 < (std::int64_t{1} << 31),
              "edge values of small triangles fit int32");

/// A tile being drawn, or some of its rows.
struct TileTarget {
  const TileClusters& clusters;
  TileRectangle pixels;
  TileRows rows;
  Span<const SampleOffset> offsets;
  SampleOffset lowest, highest;  ///< over all samples, per axis
  VisibilityTile& tile;

  PixelBox box(std::int32_t minX, std::int32_t minY, std::int32_t maxX, std::int32_t maxY) const
  {
    return {std::max(pixels.x0, (minX - highest.x + kSubpixels - 1) >> kSubpixelBits),
            std::max(rows.first, (minY - highest.y + kSubpixels - 1) >> kSubpixelBits),
            std::min(pixels.x1 - 1, (maxX - lowest.x) >> kSubpixelBits),
            std::min(rows.end - 1, (maxY - lowest.y) >> kSubpixelBits)};
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

float farthestOf(const VisibilityTile& tile, std::size_t samples, int block)
{
  const hn::CappedTag<float, kBlockSide> d;
  const int first =
      block / kBlocksPerRow * kBlockSide * kTileSide + block % kBlocksPerRow * kBlockSide;
  auto farthest = hn::Set(d, -1.0f);
  for (std::size_t s = 0; s < samples; ++s)
    for (int row = 0; row < kBlockSide; ++row)
      for (int column = 0; column < kBlockSide; column += static_cast<int>(hn::Lanes(d))) {
        const auto z = hn::Load(d, tile.depth[s] + first + row * kTileSide + column);
        farthest = hn::IfThenElse(hn::Gt(z, farthest), z, farthest);
      }
  return hn::GetLane(hn::MaxOfLanes(d, farthest));
}

/// Whether all that is as near as `nearest`, or farther, lies behind what the block shows already.
bool isBehindBlock(float nearest, std::size_t samples, int block, VisibilityTile& tile)
{
  const std::uint64_t bit = std::uint64_t{1} << block;
  if ((tile.stale & bit) != 0) {
    tile.farthest[block] = farthestOf(tile, samples, block);
    tile.stale &= ~bit;
  }
  return nearest > tile.farthest[block];
}

/// Samples that triangles cover, not yet compared with what the tile shows there.
struct WaitingSamples {
  static constexpr std::size_t kCapacity = 256;

  std::size_t count = 0;
  std::int32_t place[kCapacity + 2 * kMaxLanes];  ///< from the first plane on
  float depth[kCapacity + 2 * kMaxLanes];
  std::uint32_t owner[kCapacity + 2 * kMaxLanes];
};

/// Where opaque triangles go: each sample keeps the nearest.
struct OpaqueTarget : TileTarget {
  explicit OpaqueTarget(const TileTarget& target) : TileTarget(target) {}

  void noteDrawn(std::uint64_t blocks) const { tile.stale |= blocks; }
  void notePieces() const {}

  /// Gives the covered samples of one vector of pixels to `owner` where it is the nearest.
  template <class D, class V, class M>
  HWY_INLINE void take(D d, std::size_t sample, std::size_t index, M covered, V depth,
                       std::uint32_t owner) const
  {
    const hn::RebindToUnsigned<D> du;
    float* depths = tile.depth[sample] + index;
    std::uint32_t* owners = tile.owner[sample] + index;
    const V zero = hn::Zero(d);
    const V z = hn::IfThenElse(hn::Gt(depth, zero), depth, zero);
    const V old = hn::Load(d, depths);
    const auto visible = hn::And(covered, hn::Le(depth, hn::Set(d, 1.0f)));
    auto nearer = hn::And(visible, hn::Lt(z, old));
    const auto equal = hn::And(visible, hn::Eq(z, old));
    if (!hn::AllFalse(d, equal)) {
      float wins[HWY_MAX_BYTES / sizeof(float)];
      for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
        wins[lane] = clusters.drawnLater(owner, owners[lane]) ? 1.0f : 0.0f;
      nearer = hn::Or(nearer, hn::And(equal, hn::Gt(hn::LoadU(d, wins), zero)));
    }
    hn::Store(hn::IfThenElse(nearer, z, old), d, depths);
    const auto oldOwner = hn::Load(du, owners);
    hn::Store(hn::IfThenElse(hn::RebindMask(du, nearer), hn::Set(du, owner), oldOwner), du, owners);
  }

  /// Gives one sample each of some triangles, one a lane, to them, where they are the nearest: by
  /// and by, flush() does the rest. Takes and returns countWaiting(), so that it stays in a
  /// register.
  HWY_INLINE std::size_t takeEach(std::size_t sample,
                                  hn::Mask<hn::ScalableTag<std::int32_t>> covered,
                                  hn::Vec<hn::ScalableTag<float>> z,
                                  hn::Vec<hn::ScalableTag<std::int32_t>> index,
                                  hn::Vec<hn::ScalableTag<std::uint32_t>> owner,
                                  std::size_t count) const
  {
    const hn::ScalableTag<float> df;
    const hn::ScalableTag<std::int32_t> d;
    const hn::ScalableTag<std::uint32_t> du;
    const auto zero = hn::Zero(df);
    const auto inView = hn::And(hn::RebindMask(df, covered), hn::Le(z, hn::Set(df, 1.0f)));
    const std::uint64_t bits = bitsOf(df, inView);
    const auto near = hn::IfThenElse(hn::Gt(z, zero), z, zero);
    const auto plane = static_cast<std::int32_t>(sample * kTilePixels);
    compressStoreBits(d, hn::Add(index, hn::Set(d, plane)), bits, waiting_.place + count);
    compressStoreBits(df, near, bits, waiting_.depth + count);
    count += compressStoreBits(du, owner, bits, waiting_.owner + count);
    if (HWY_LIKELY(count <= WaitingSamples::kCapacity)) return count;
    setWaiting(count);
    flush();
    return 0;
  }
  std::size_t countWaiting() const { return waiting_.count; }
  void setWaiting(std::size_t count) const { waiting_.count = count; }

  /// One sample after the other, without a branch that cannot be foreseen.
  void flush() const
  {
    float* const depths = tile.depth[0];
    std::uint32_t* const owners = tile.owner[0];
    const std::size_t count = waiting_.count;
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t at = waiting_.place[i];
      const float fresh = waiting_.depth[i], old = depths[at];
      const std::uint32_t owner = waiting_.owner[i], oldOwner = owners[at];
      bool nearer = fresh < old;
      if (HWY_UNLIKELY(fresh == old)) nearer = clusters.drawnLater(owner, oldOwner);
      const std::uint32_t mask = nearer ? ~std::uint32_t{0} : 0;
      depths[at] = nearer ? fresh : old;
      owners[at] = oldOwner ^ ((oldOwner ^ owner) & mask);
    }
    waiting_.count = 0;
  }

 private:
  mutable WaitingSamples waiting_;
};

/// Where translucent triangles go: all of them are kept that no opaque one hides.
struct TranslucentTarget : TileTarget {
  TranslucentTarget(const TileTarget& target, TranslucentTile& kept)
      : TileTarget(target), translucent(kept)
  {
  }

  void noteDrawn(std::uint64_t) const {}
  void notePieces() const { translucent.notePieces(); }

  template <class D, class V, class M>
  HWY_INLINE void take(D d, std::size_t sample, std::size_t index, M covered, V depth,
                       std::uint32_t owner) const
  {
    const hn::RebindToUnsigned<D> du;
    const V zero = hn::Zero(d);
    const V z = hn::IfThenElse(hn::Gt(depth, zero), depth, zero);
    const auto inView = hn::And(covered, hn::Le(depth, hn::Set(d, 1.0f)));
    const auto visible = hn::And(inView, hn::Le(z, hn::Load(d, tile.depth[sample] + index)));
    if (hn::AllFalse(d, visible)) return;
    const auto place = hn::Or(hn::ShiftLeft<TranslucentTile::kSampleBits>(
                                  hn::Iota(du, static_cast<std::uint32_t>(index))),
                              hn::Set(du, static_cast<std::uint32_t>(sample)));
    add(d, hn::RebindMask(du, visible), visible, place, hn::Set(du, owner), z);
  }

  HWY_INLINE std::size_t takeEach(std::size_t sample,
                                  hn::Mask<hn::ScalableTag<std::int32_t>> covered,
                                  hn::Vec<hn::ScalableTag<float>> z,
                                  hn::Vec<hn::ScalableTag<std::int32_t>> index,
                                  hn::Vec<hn::ScalableTag<std::uint32_t>> owner, std::size_t) const
  {
    const hn::ScalableTag<float> df;
    const hn::ScalableTag<std::uint32_t> du;
    const auto zero = hn::Zero(df);
    const auto near = hn::IfThenElse(hn::Gt(z, zero), z, zero);
    const auto inView = hn::And(hn::RebindMask(df, covered), hn::Le(z, hn::Set(df, 1.0f)));
    const auto behind = hn::GatherIndex(df, tile.depth[sample], hn::IfThenElseZero(covered, index));
    const auto visible = hn::And(inView, hn::Le(near, behind));
    if (hn::AllFalse(df, visible)) return 0;
    const auto place = hn::Or(hn::ShiftLeft<TranslucentTile::kSampleBits>(hn::BitCast(du, index)),
                              hn::Set(du, static_cast<std::uint32_t>(sample)));
    add(df, hn::RebindMask(du, visible), visible, place, owner, near);
    return 0;
  }
  std::size_t countWaiting() const { return 0; }
  void setWaiting(std::size_t) const {}
  void flush() const {}

 private:
  template <class D, class M, class MU, class VU, class V>
  HWY_INLINE void add(D d, MU chosen, M visible, VU place, VU owner, V depth) const
  {
    const hn::RebindToUnsigned<D> du;
    compressStore(du, place, chosen, translucent.placeEnd());
    compressStore(du, owner, chosen, translucent.ownerEnd());
    translucent.grow(compressStore(d, depth, visible, translucent.depthEnd()));
  }

 public:
  TranslucentTile& translucent;
};

/// Any triangle, block by block, with edge values in double: they stay below 2^50, so every step is
/// exact.
template <class Target>
class LargeTriangle {
 public:
  LargeTriangle(const OrientedTriangle& triangle, std::uint32_t owner, const Target& target)
      : owner_(owner),
        target_(target),
        plane_(triangle.corner[0].depth, triangle.corner[1].depth, triangle.corner[2].depth,
               static_cast<float>(triangle.area))
  {
    const auto& c = triangle.corner;
    box_ = target.box(std::min({c[0].x, c[1].x, c[2].x}), std::min({c[0].y, c[1].y, c[2].y}),
                      std::max({c[0].x, c[1].x, c[2].x}), std::max({c[0].y, c[1].y, c[2].y}));
    if (box_.empty()) return;
    blocks_ = {(box_.x0 - target.pixels.x0) / kBlockSide, (box_.y0 - target.pixels.y0) / kBlockSide,
               (box_.x1 - target.pixels.x0) / kBlockSide,
               (box_.y1 - target.pixels.y0) / kBlockSide};
    for (int i = 0; i < 3; ++i)
      edge_[i] = edgeAtBlocks(triangle.edge[i]);
    findNearest();
  }

  void draw() const
  {
    if (box_.empty()) return;
    const bool culls = target_.clusters.scene->optimizations.occlusionCulling;
    for (int y = blocks_.y0; y <= blocks_.y1; ++y) {
      std::int64_t most[3];
      for (int i = 0; i < 3; ++i)
        most[i] = edge_[i].most + (y - blocks_.y0) * edge_[i].perBlockY;
      for (int x = blocks_.x0; x <= blocks_.x1; ++x) {
        const bool isOutside = (most[0] | most[1] | most[2]) < 0;
        const bool isInside =
            most[0] >= edge_[0].span && most[1] >= edge_[1].span && most[2] >= edge_[2].span;
        for (int i = 0; i < 3; ++i)
          most[i] += edge_[i].perBlockX;
        if (isOutside || (culls && isBehind(x, y))) continue;
        drawBlock(x, y, isInside);
      }
    }
  }

 private:
  /// An edge function over the samples of blocks, of which the first is blocks_'s lower left one.
  struct BlockEdge {
    std::int64_t most;  ///< of the first block's samples, less the smallest value inside
    std::int64_t span;  ///< between the most and the least of a block's samples
    std::int64_t perBlockX, perBlockY;
    double first;  ///< at the corner of the first block's first pixel
    double perPixelY;
    double perSubpixelX, perSubpixelY;
    double smallestInside;
    alignas(64) double perColumn[kBlockSide];
  };

  BlockEdge edgeAtBlocks(const EdgeFunction& e) const
  {
    constexpr std::int64_t kBlock = kBlockSide * kSubpixels;
    const std::int64_t x = (target_.pixels.x0 + blocks_.x0 * kBlockSide) * kSubpixels,
                       y = (target_.pixels.y0 + blocks_.y0 * kBlockSide) * kSubpixels;
    const std::int64_t x0 = x + target_.lowest.x, x1 = x + kBlock - kSubpixels + target_.highest.x,
                       y0 = y + target_.lowest.y, y1 = y + kBlock - kSubpixels + target_.highest.y;
    BlockEdge edge;
    edge.most = e.at(e.a > 0 ? x1 : x0, e.b > 0 ? y1 : y0) - e.smallestInside;
    edge.span = std::llabs(e.a) * (x1 - x0) + std::llabs(e.b) * (y1 - y0);
    edge.perBlockX = e.a * kBlock;
    edge.perBlockY = e.b * kBlock;
    edge.first = static_cast<double>(e.at(x, y));
    edge.perPixelY = static_cast<double>(e.b * kSubpixels);
    edge.perSubpixelX = static_cast<double>(e.a);
    edge.perSubpixelY = static_cast<double>(e.b);
    edge.smallestInside = static_cast<double>(e.smallestInside);
    for (int column = 0; column < kBlockSide; ++column)
      edge.perColumn[column] = static_cast<double>(e.a * kSubpixels * column);
    return edge;
  }

  /// The depth below which no computed one of a block's samples is.
  void findNearest()
  {
    const double z1 = plane_.z1, z2 = plane_.z2;
    const auto slope = [&](double e1, double e2) { return e1 * z1 + e2 * z2; };
    // The plane over e1 and e2 is a plane over x and y: least where its slopes say so.
    const double perX = slope(edge_[1].perSubpixelX, edge_[2].perSubpixelX);
    const double perY = slope(edge_[1].perSubpixelY, edge_[2].perSubpixelY);
    constexpr int kLast = (kBlockSide - 1) * kSubpixels;
    const double x = perX > 0 ? target_.lowest.x : kLast + target_.highest.x;
    const double y = perY > 0 ? target_.lowest.y : kLast + target_.highest.y;
    const auto valueAt = [&](int i) {
      return edge_[i].first + x * edge_[i].perSubpixelX + y * edge_[i].perSubpixelY;
    };
    // The steps in float err by at most 2^-24 of their results, five times.
    constexpr double kFloatError = 0x1p-21;
    nearest_ = plane_.z0 + slope(valueAt(1), valueAt(2)) -
               kFloatError *
                   (std::fabs(plane_.z0) + largest(1) * std::fabs(z1) + largest(2) * std::fabs(z2));
    nearestPerBlockX_ = perX * (kBlockSide * kSubpixels);
    nearestPerBlockY_ = perY * (kBlockSide * kSubpixels);
  }

  /// The largest magnitude of an edge function over all blocks' samples.
  double largest(int i) const
  {
    const BlockEdge& e = edge_[i];
    const std::int64_t acrossX = (blocks_.x1 - blocks_.x0) * e.perBlockX,
                       acrossY = (blocks_.y1 - blocks_.y0) * e.perBlockY;
    const std::int64_t most =
        e.most + std::max<std::int64_t>(acrossX, 0) + std::max<std::int64_t>(acrossY, 0);
    const std::int64_t least =
        e.most - e.span + std::min<std::int64_t>(acrossX, 0) + std::min<std::int64_t>(acrossY, 0);
    return static_cast<double>(std::max(std::llabs(least), std::llabs(most)) + 1);
  }

  bool isBehind(int blockX, int blockY) const
  {
    const double nearest = nearest_ + (blockX - blocks_.x0) * nearestPerBlockX_ +
                           (blockY - blocks_.y0) * nearestPerBlockY_;
    return isBehindBlock(static_cast<float>(nearest), target_.offsets.size(),
                         blockY * kBlocksPerRow + blockX, target_.tile);
  }

  void drawBlock(int blockX, int blockY, bool isInside) const
  {
    target_.noteDrawn(std::uint64_t{1} << (blockY * kBlocksPerRow + blockX));
    const int y = target_.pixels.y0 + blockY * kBlockSide;
    const int firstRow = std::max(box_.y0 - y, 0);
    const int lastRow = std::min(box_.y1 - y, kBlockSide - 1);
    for (std::size_t s = 0; s < target_.offsets.size(); ++s)
      if (isInside)
        drawRows<false>(s, blockX, blockY, firstRow, lastRow);
      else
        drawRows<true>(s, blockX, blockY, firstRow, lastRow);
  }

  /// Some rows of a block, the last one included.
  template <bool kHasEdge>
  HWY_INLINE void drawRows(std::size_t sample, int blockX, int blockY, int firstRow,
                           int lastRow) const
  {
    const hn::CappedTag<float, kBlockSide> df;
    const SampleOffset offset = target_.offsets[sample];
    const int right = (blockX - blocks_.x0) * kBlockSide,
              up = (blockY - blocks_.y0) * kBlockSide + firstRow;
    double first[3];
    for (int i = 0; i < 3; ++i)
      first[i] = edge_[i].first + (right * kSubpixels + offset.x) * edge_[i].perSubpixelX +
                 (up * kSubpixels + offset.y) * edge_[i].perSubpixelY;
    const auto z0 = hn::Set(df, plane_.z0), z1 = hn::Set(df, plane_.z1),
               z2 = hn::Set(df, plane_.z2);
    auto index = static_cast<std::size_t>((blockY * kBlockSide + firstRow) * kTileSide +
                                          blockX * kBlockSide);
    for (int row = firstRow; row <= lastRow; ++row, index += kTileSide) {
      for (std::size_t column = 0; column < kBlockSide; column += hn::Lanes(df)) {
        const auto edgesFrom = [&](int i, double value) HWY_ATTR {
          return edgesOfRow(df, value, edge_[i].perColumn + column);
        };
        auto covered = hn::Eq(hn::Zero(df), hn::Zero(df));
        if (kHasEdge) {
          // Rounding to float keeps the sign.
          const auto inside = [&](int i) HWY_ATTR {
            return hn::Ge(edgesFrom(i, first[i] - edge_[i].smallestInside), hn::Zero(df));
          };
          covered = hn::And(inside(0), hn::And(inside(1), inside(2)));
          if (hn::AllFalse(df, covered)) continue;
        }
        const auto e1 = edgesFrom(1, first[1]), e2 = edgesFrom(2, first[2]);
        const auto z = hn::Add(z0, hn::Add(hn::Mul(e1, z1), hn::Mul(e2, z2)));
        target_.take(df, sample, index + column, covered, z, owner_);
      }
      for (int i = 0; i < 3; ++i)
        first[i] += edge_[i].perPixelY;
    }
  }

  std::uint32_t owner_;
  const Target& target_;
  DepthPlane plane_;
  PixelBox box_;     ///< of pixels of the tile
  PixelBox blocks_;  ///< of blocks, counted from the tile's first
  BlockEdge edge_[3];
  double nearest_;  ///< findNearest() of the first block
  double nearestPerBlockX_, nearestPerBlockY_;
};

struct SmallTriangle {
  std::int32_t x[3], y[3];
  float depth[3];
};

/// A counter-clockwise triangle with a box below kSmallBox, with edge values in int32.
template <class Target>
HWY_INLINE void drawSmall(const SmallTriangle& triangle, std::int32_t area, std::uint32_t owner,
                          const Target& target)
{
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const auto& x = triangle.x;
  const auto& y = triangle.y;
  const PixelBox box = target.box(std::min({x[0], x[1], x[2]}), std::min({y[0], y[1], y[2]}),
                                  std::max({x[0], x[1], x[2]}), std::max({y[0], y[1], y[2]}));
  if (box.empty()) return;
  const DepthPlane plane(triangle.depth[0], triangle.depth[1], triangle.depth[2],
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
  const auto z0 = hn::Set(d, plane.z0), z1 = hn::Set(d, plane.z1), z2 = hn::Set(d, plane.z2);
  const auto inside1 = hn::Set(di, least[1]), inside2 = hn::Set(di, least[2]);
  const auto perVector = [&](int i) HWY_ATTR { return hn::Set(di, stepX[i] * lanes); };
  const auto right0 = perVector(0), right1 = perVector(1), right2 = perVector(2);
  const auto up0 = hn::Set(di, stepY[0]), up1 = hn::Set(di, stepY[1]), up2 = hn::Set(di, stepY[2]);
  const int columns = box.x1 - firstX;
  for (std::size_t s = 0; s < target.offsets.size(); ++s) {
    const SampleOffset offset = target.offsets[s];
    const auto edgeAt = [&](int i) HWY_ATTR {
      const std::int32_t here =
          start[i] + (stepX[i] / kSubpixels) * offset.x + (stepY[i] / kSubpixels) * offset.y;
      return hn::Add(hn::Set(di, here), hn::Mul(ramp, hn::Set(di, stepX[i])));
    };
    auto row0 = hn::Sub(edgeAt(0), hn::Set(di, least[0])), row1 = edgeAt(1), row2 = edgeAt(2);
    auto index = static_cast<std::size_t>((box.y0 - target.pixels.y0) * kTileSide + firstX -
                                          target.pixels.x0);
    for (int row = box.y0; row <= box.y1; ++row, index += kTileSide) {
      auto e0 = row0, e1 = row1, e2 = row2;
      for (int column = 0; column <= columns; column += lanes) {
        const auto under = hn::Or(e0, hn::Or(hn::Sub(e1, inside1), hn::Sub(e2, inside2)));
        const auto covered = hn::RebindMask(d, hn::Gt(under, hn::Set(di, -1)));
        if (!hn::AllFalse(d, covered)) {
          const auto z = hn::Add(
              z0, hn::Add(hn::Mul(hn::ConvertTo(d, e1), z1), hn::Mul(hn::ConvertTo(d, e2), z2)));
          target.take(d, s, index + static_cast<std::size_t>(column), covered, z, owner);
        }
        e0 = hn::Add(e0, right0);
        e1 = hn::Add(e1, right1);
        e2 = hn::Add(e2, right2);
      }
      row0 = hn::Add(row0, up0);
      row1 = hn::Add(row1, up1);
      row2 = hn::Add(row2, up2);
    }
  }
}

/// drawSmall() of a triangle of any winding.
template <class Target>
void drawOriented(SmallTriangle triangle, const Instance& instance, std::uint32_t owner,
                  const Target& target)
{
  const auto &x = triangle.x, &y = triangle.y;
  const std::int32_t area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  if (area == 0 || (area < 0 ? instance.cullBackFaces : instance.cullFrontFaces)) return;
  if (area < 0) {
    std::swap(triangle.x[1], triangle.x[2]);
    std::swap(triangle.y[1], triangle.y[2]);
    std::swap(triangle.depth[1], triangle.depth[2]);
  }
  drawSmall(triangle, area < 0 ? -area : area, owner, target);
}

/// Draws one triangle by the general way: clipped pieces, or a box too large for int32.
template <class Target>
void drawGeneral(const PlacedCluster& cluster, const ScreenVertices& screen, std::uint32_t triangle,
                 std::uint32_t owner, const Target& target)
{
  const Instance& instance = *cluster.placed->instance;
  const auto drawPiece = [&](const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
    OrientedTriangle oriented;
    if (!orient(a, b, c, oriented)) return;
    if (oriented.clockwise ? instance.cullBackFaces : instance.cullFrontFaces) return;
    LargeTriangle<Target>(oriented, owner, target).draw();
  };
  const ScreenVertex corner[3] = {screen.vertex(cluster.corner(triangle, 0)),
                                  screen.vertex(cluster.corner(triangle, 1)),
                                  screen.vertex(cluster.corner(triangle, 2))};
  if (!corner[0].needsClip && !corner[1].needsClip && !corner[2].needsClip) {
    drawPiece(corner[0], corner[1], corner[2]);
    return;
  }
  target.notePieces();
  const ClippedTriangle polygon = clipClusterTriangle(cluster, triangle);
  for (int i = 1; i + 1 < polygon.count; ++i)
    drawPiece(polygon.vertex[0], polygon.vertex[i], polygon.vertex[i + 1]);
}

/// Sets up a vector of triangles at once, drops those that cover no sample of the tile, and draws
/// the rest.
template <class Target>
void drawAnyCluster(const PlacedCluster& cluster, const ScreenVertices& screen, std::uint32_t slot,
                    const Target& target)
{
  const hn::ScalableTag<std::int32_t> d;
  const hn::Rebind<std::uint8_t, decltype(d)> d8;

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
    const auto missY = hn::Gt(firstPixel(minY, target.highest.y, target.rows.first),
                              lastPixel(maxY, target.lowest.y, target.rows.end - 1));

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

    std::uint8_t keptBits[8] = {}, generalBits[8] = {};
    hn::StoreMaskBits(d, kept, keptBits);
    hn::StoreMaskBits(d, general, generalBits);
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
      SmallTriangle corners;
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t v = cluster.corner(triangle, k);
        corners.x[k] = screen.x[v];
        corners.y[k] = screen.y[v];
        corners.depth[k] = screen.depth[v];
      }
      drawOriented(corners, instance, owner, target);
    }
  }
}

#if HWY_TARGET != HWY_SCALAR

/// Looks up a vector of vertices in an array of kMaxClusterVertices.
template <class T>
class VertexTable {
 public:
  using D = hn::ScalableTag<T>;
  using V = hn::Vec<D>;
  using Index = hn::Vec<hn::RebindToSigned<D>>;

#if HWY_TARGET == HWY_AVX3
  // The whole table in four registers: a gather costs more than the two permutes and the blend.
  explicit VertexTable(const T* table)
  {
    for (int i = 0; i < 4; ++i)
      quarter_[i] = _mm512_load_si512(table + i * 16);
  }
  HWY_INLINE V operator[](Index i) const
  {
    const __m512i lower = _mm512_permutex2var_epi32(quarter_[0], i.raw, quarter_[1]);
    const __m512i upper = _mm512_permutex2var_epi32(quarter_[2], i.raw, quarter_[3]);
    const __mmask16 inUpper = _mm512_test_epi32_mask(i.raw, _mm512_set1_epi32(32));
    const auto found =
        hn::Vec<hn::RebindToSigned<D>>{_mm512_mask_blend_epi32(inUpper, lower, upper)};
    return hn::BitCast(D(), found);
  }

 private:
  __m512i quarter_[4];
#else
  explicit VertexTable(const T* table) : table_(table) {}
  HWY_INLINE V operator[](Index i) const
  {
    alignas(64) std::int32_t at[kMaxLanes];
    hn::Store(i, hn::RebindToSigned<D>(), at);
    return gatherLanes(D(), table_, at);
  }

 private:
  const T* table_;
#endif
};

/// Looks up a vector of vertices in an array of kMaxClusterVertices bytes.
class ByteTable {
 public:
  using D = hn::ScalableTag<std::uint8_t>;
  using V = hn::Vec<D>;

  /// Numbers below kMaxClusterVertices: their low four bits, and bits 4 and 5 as signs.
  struct Index {
    V low;
    hn::Vec<hn::RebindToSigned<D>> bit4, bit5;

    explicit Index(V i) : low(hn::And(i, hn::Set(D(), 15))), bit4(signOf<3>(i)), bit5(signOf<2>(i))
    {
    }

   private:
    template <int kShift>
    static HWY_INLINE hn::Vec<hn::RebindToSigned<D>> signOf(V i)
    {
      const hn::RebindToSigned<D> d;
      const auto sign = hn::BitCast(d, hn::ShiftLeft<kShift>(i));
#if HWY_TARGET == HWY_SSSE3
      // Highway 1.0.3 takes each bit there for its own sign.
      return hn::VecFromMask(d, hn::Lt(sign, hn::Zero(d)));
#else
      return sign;
#endif
    }
  };

  explicit ByteTable(const std::uint8_t* table)
  {
    for (int i = 0; i < 4; ++i)
      quarter_[i] = hn::LoadDup128(D(), table + i * 16);
  }
  HWY_INLINE V operator[](const Index& i) const
  {
    const auto found = [&](int quarter) HWY_ATTR {
      return hn::BitCast(hn::RebindToSigned<D>(), hn::TableLookupBytes(quarter_[quarter], i.low));
    };
    const auto lower = hn::IfNegativeThenElse(i.bit4, found(1), found(0));
    const auto upper = hn::IfNegativeThenElse(i.bit4, found(3), found(2));
    return hn::BitCast(D(), hn::IfNegativeThenElse(i.bit5, upper, lower));
  }

 private:
  V quarter_[4];
};

/// Two 16-bit coordinates in 32 bits: x low, y high.
constexpr std::int32_t packed(std::int32_t x, std::int32_t y)
{
  return static_cast<std::int32_t>((static_cast<std::uint32_t>(y) << 16) |
                                   (static_cast<std::uint32_t>(x) & 0xFFFFu));
}

/// A whole cluster below kSmallBox, with vertices relative to its box.
template <class Target>
class SmallCluster {
  static_assert(kSmallBox + 2 * kSubpixels < 1 << 15, "coordinates in a cluster fit int16");
  /// Makes the pixels beside a cluster's vertices, relative to its box, positive.
  static constexpr int kPixelBias = 2;
  static_assert(kSmallBox / kSubpixels + 2 + kPixelBias < 128, "pixels of a cluster fit 7 bits");

 public:
  SmallCluster(const TileCluster& cluster, std::uint32_t slot, const Target& target)
      : instance_(*cluster.cluster.placed->instance),
        mesh_(cluster.cluster.mesh()),
        bounds_(cluster.bounds),
        slot_(slot),
        target_(target),
        baseX_(cluster.bounds.x0),
        baseY_(cluster.bounds.y0)
  {
    const InstanceTransform& transform = cluster.cluster.placed->transform;
    if (transform.precise)
      placeInDouble(transform);
    else
      placeInFloat(transform);
    notePixels();
  }

  void draw()
  {
    Sifted sifted;
    sift(sifted);
    drawFew(sifted.tiny);
    drawFew(sifted.few);
    target_.flush();
    for (std::size_t i = 0; i < sifted.many.count; ++i)
      drawMany(static_cast<std::uint32_t>(sifted.many.triangle[i]));
  }

 private:
  static constexpr hn::ScalableTag<std::int32_t> d{};
  static constexpr hn::ScalableTag<float> df{};
  using VI = hn::Vec<hn::ScalableTag<std::int32_t>>;
  using VF = hn::Vec<hn::ScalableTag<float>>;

  /// The vertices as transformVertices() has them, but relative and without what is not needed: of
  /// a whole cluster none needs clipping.
  void placeInFloat(const InstanceTransform& transform)
  {
    const std::size_t first = bounds_.firstVertex;
    const VF baseX = hn::Set(df, static_cast<float>(baseX_ * kSubpixels));
    const VF baseY = hn::Set(df, static_cast<float>(baseY_ * kSubpixels));
    // Adding this rounds to whole numbers, to even ones of two, which stand in the low bits. What
    // is subtracted is whole and even, and leaves small numbers without an error.
    const VF whole = hn::Set(df, 0x1.8p23f);
    for (std::size_t i = 0; i < bounds_.vertexCount; i += hn::Lanes(df)) {
      const auto lanes = viewportLanes(
          df, transform,
          clipLanes(df, transform.toClipFloat, hn::LoadU(df, mesh_.x.data() + first + i),
                    hn::LoadU(df, mesh_.y.data() + first + i),
                    hn::LoadU(df, mesh_.z.data() + first + i)));
      const VI x = hn::BitCast(d, hn::Add(hn::Sub(lanes.x, baseX), whole));
      const VI y = hn::BitCast(d, hn::Add(hn::Sub(lanes.y, baseY), whole));
      hn::Store(hn::Or(hn::And(x, hn::Set(d, 0xFFFF)), hn::ShiftLeft<16>(y)), d, packed_ + i);
      hn::Store(lanes.depth, df, depth_ + i);
    }
  }
  void placeInDouble(const InstanceTransform& transform)
  {
    const hn::ScalableTag<double> dd;
    const hn::Rebind<float, decltype(dd)> dhf;
    const hn::Rebind<std::int32_t, decltype(dd)> dh;
    const std::size_t first = bounds_.firstVertex;
    const auto load = [&](const Array<float>& high, const Array<float>& low,
                          std::size_t i) HWY_ATTR {
      const auto h = hn::PromoteTo(dd, hn::LoadU(dhf, high.data() + first + i));
      const auto l =
          low.empty() ? hn::Zero(dd) : hn::PromoteTo(dd, hn::LoadU(dhf, low.data() + first + i));
      return hn::Add(h, l);
    };
    const auto baseX = hn::Set(dh, baseX_ * kSubpixels), baseY = hn::Set(dh, baseY_ * kSubpixels);
    for (std::size_t i = 0; i < bounds_.vertexCount; i += hn::Lanes(dd)) {
      const auto lanes =
          viewportLanes(dd, transform,
                        clipLanes(dd, transform.toClip, load(mesh_.x, mesh_.xLow, i),
                                  load(mesh_.y, mesh_.yLow, i), load(mesh_.z, mesh_.zLow, i)));
      const auto x = hn::Sub(hn::DemoteTo(dh, hn::Round(lanes.x)), baseX);
      const auto y = hn::Sub(hn::DemoteTo(dh, hn::Round(lanes.y)), baseY);
      hn::Store(hn::Or(hn::And(x, hn::Set(dh, 0xFFFF)), hn::ShiftLeft<16>(y)), dh, packed_ + i);
      hn::Store(hn::DemoteTo(dhf, lanes.depth), dhf, depth_ + i);
    }
  }

  /// A triangle in 32 bits: its number, and its corners' numbers.
  static HWY_INLINE VI cornerOf(VI triangle, int k)
  {
    const VI mask = hn::Set(d, kMaxClusterVertices - 1);
    return k == 0   ? hn::And(triangle, mask)
           : k == 1 ? hn::And(hn::ShiftRight<8>(triangle), mask)
                    : hn::And(hn::ShiftRight<16>(triangle), mask);
  }
  static std::uint32_t numberOf(std::uint32_t triangle) { return triangle >> 24; }

  struct Triangles {
    std::size_t count = 0;
    std::int32_t triangle[kMaxClusterTriangles + kMaxLanes];
  };
  /// Triangles by the pixels of the tile that their boxes meet. Vectors of triangles take as long
  /// as the largest of them.
  struct Sifted {
    Triangles tiny;  ///< up to 2 x 2
    Triangles few;   ///< up to 8 x 8
    Triangles many;
  };

  /// Notes for each vertex the pixels beside it, in one byte an axis; see sift().
  void notePixels()
  {
    const hn::Repartition<std::int16_t, decltype(d)> d16;
    const hn::Rebind<std::uint8_t, decltype(d)> d8;
    const auto both = [&](std::int32_t x, std::int32_t y)
                          HWY_ATTR { return hn::BitCast(d16, hn::Set(d, packed(x, y))); };
    const auto up = both(kSubpixels - 1 - target_.highest.x, kSubpixels - 1 - target_.highest.y);
    const auto down = both(target_.lowest.x, target_.lowest.y);
    const auto bias = both(2 * kPixelBias, 2 * kPixelBias);
    for (std::size_t i = 0; i < bounds_.vertexCount; i += hn::Lanes(d)) {
      const auto at = hn::BitCast(d16, hn::Load(d, packed_ + i));
      const auto after = hn::ShiftRight<kSubpixelBits>(hn::Add(at, up));
      const auto before = hn::ShiftRight<kSubpixelBits>(hn::Sub(at, down));
      const auto sum = hn::BitCast(du, hn::Add(bias, hn::Add(after, before)));
      hn::StoreU(hn::U8FromU32(hn::And(sum, hn::Set(du, 0xFF))), d8, pixelX_ + i);
      hn::StoreU(hn::U8FromU32(hn::ShiftRight<16>(sum)), d8, pixelY_ + i);
    }
  }

  /// Sorts out the triangles whose box holds a sample of the tile. The rest, most of a fine mesh,
  /// ends here.
  ///
  /// The first pixel with a sample not left of a vertex, f, is t or t + 1, where t is the last with
  /// one not right of it. So f + t holds both, halved upward and downward, and as both grow with x
  /// those of the box are those of the least and the greatest f + t.
  void sift(Sifted& sifted) const
  {
    const hn::ScalableTag<std::uint8_t> d8;
    const hn::RebindToSigned<decltype(d8)> di8;
    const ByteTable tableX(pixelX_), tableY(pixelY_);
    // Below 128 are all pixels of the cluster, so that signed comparisons serve.
    const auto border = [&](int pixel, std::int32_t base) HWY_ATTR {
      const int relative = std::min(std::max(pixel - base + kPixelBias, 0), 127);
      return hn::Set(d8, static_cast<std::uint8_t>(relative));
    };
    const auto x0 = border(target_.pixels.x0, baseX_), x1 = border(target_.pixels.x1 - 1, baseX_);
    const auto y0 = border(target_.rows.first, baseY_), y1 = border(target_.rows.end - 1, baseY_);
    const auto first = [&](auto a, auto b, auto c, auto from) HWY_ATTR {
      const auto least = hn::Min(a, hn::Min(b, c));
      return hn::BitCast(di8, hn::Max(hn::AverageRound(least, hn::Zero(d8)), from));
    };
    const auto last = [&](auto a, auto b, auto c, auto to) HWY_ATTR {
      const auto most = hn::Max(a, hn::Max(b, c));
      return hn::BitCast(di8, hn::Min(hn::ShiftRight<1>(most), to));
    };
    const std::uint8_t* const corner[3] = {mesh_.corner[0].data() + bounds_.firstTriangle,
                                           mesh_.corner[1].data() + bounds_.firstTriangle,
                                           mesh_.corner[2].data() + bounds_.firstTriangle};
    const std::size_t count = bounds_.triangleCount;
    for (std::size_t t = 0; t < count; t += hn::Lanes(d8)) {
      // Behind the last triangle there are vertex numbers of some other cluster, below 64.
      const ByteTable::Index i0(hn::LoadU(d8, corner[0] + t)), i1(hn::LoadU(d8, corner[1] + t)),
          i2(hn::LoadU(d8, corner[2] + t));
      const auto xa = tableX[i0], xb = tableX[i1], xc = tableX[i2];
      const auto ya = tableY[i0], yb = tableY[i1], yc = tableY[i2];
      const auto spanX = hn::Sub(last(xa, xb, xc, x1), first(xa, xb, xc, x0));
      const auto spanY = hn::Sub(last(ya, yb, yc, y1), first(ya, yb, yc, y0));
      const auto missed = hn::Lt(hn::Min(spanX, spanY), hn::Zero(di8));
      const std::uint64_t real =
          count - t < 64 ? (std::uint64_t{1} << (count - t)) - 1 : ~std::uint64_t{0};
      const std::uint64_t kept = bitsOf(di8, hn::Not(missed)) & real;
      if (kept == 0) continue;
      const auto span = hn::Max(spanX, spanY);
      const std::uint64_t beyondTiny = kept & bitsOf(di8, hn::Gt(span, hn::Set(di8, 1)));
      add(corner, t, kept & ~beyondTiny, sifted.tiny);
      if (beyondTiny == 0) continue;
      const std::uint64_t beyondFew = kept & bitsOf(di8, hn::Gt(span, hn::Set(di8, 7)));
      add(corner, t, beyondTiny & ~beyondFew, sifted.few);
      add(corner, t, beyondFew, sifted.many);
    }
  }
  /// Triangles from `first` on, one for each bit.
  static HWY_INLINE void add(const std::uint8_t* const* corner, std::size_t first,
                             std::uint64_t chosen, Triangles& to)
  {
    const hn::Rebind<std::uint8_t, decltype(d)> d8;
    for (std::size_t t = first; chosen != 0; t += hn::Lanes(d), chosen >>= hn::Lanes(d)) {
      const std::uint64_t here = chosen & ((std::uint64_t{1} << hn::Lanes(d)) - 1);
      if (here == 0) continue;
      const auto load = [&](int k)
                            HWY_ATTR { return hn::PromoteTo(d, hn::LoadU(d8, corner[k] + t)); };
      const VI number = hn::Iota(d, static_cast<std::int32_t>(t));
      const VI triangle = hn::Or(hn::Or(load(0), hn::ShiftLeft<8>(load(1))),
                                 hn::Or(hn::ShiftLeft<16>(load(2)), hn::ShiftLeft<24>(number)));
      to.count += compressStoreBits(d, triangle, here, to.triangle + to.count);
    }
  }

  /// Draws a vector of triangles at a time, pixel by pixel of their boxes.
  void drawFew(Triangles& triangles) const
  {
    const std::size_t count = triangles.count;
    if (count == 0) return;
    hn::StoreU(hn::Zero(d), d, triangles.triangle + count);
    const VertexTable<std::int32_t> vertices(packed_);
    for (std::size_t t = 0; t < count; t += hn::Lanes(d)) {
      const VI triangle = hn::LoadU(d, triangles.triangle + t);
      const auto real = hn::Lt(hn::Iota(d, static_cast<std::int32_t>(t)),
                               hn::Set(d, static_cast<std::int32_t>(count)));
      drawVector(vertices, triangle, real);
    }
  }

  HWY_INLINE void drawVector(const VertexTable<std::int32_t>& vertices, VI triangle,
                             hn::Mask<hn::ScalableTag<std::int32_t>> real) const
  {
    const VI zero = hn::Zero(d);
    const VI i0 = cornerOf(triangle, 0), i1 = cornerOf(triangle, 1), i2 = cornerOf(triangle, 2);
    const VI p0 = vertices[i0], p1 = vertices[i1], p2 = vertices[i2];
    const auto xOf = [](VI p) HWY_ATTR { return hn::ShiftRight<16>(hn::ShiftLeft<16>(p)); };
    const auto yOf = [](VI p) HWY_ATTR { return hn::ShiftRight<16>(p); };
    const VI x0 = xOf(p0), y0 = yOf(p0);
    const VI area = hn::Sub(hn::Mul(hn::Sub(xOf(p1), x0), hn::Sub(yOf(p2), y0)),
                            hn::Mul(hn::Sub(xOf(p2), x0), hn::Sub(yOf(p1), y0)));
    const auto clockwise = hn::Lt(area, zero);
    auto drawn = hn::And(real, hn::Ne(area, zero));
    if (instance_.cullBackFaces) drawn = hn::AndNot(clockwise, drawn);
    if (instance_.cullFrontFaces) drawn = hn::And(drawn, clockwise);
    if (hn::AllFalse(d, drawn)) return;
    const VI q1 = hn::IfThenElse(clockwise, p2, p1), q2 = hn::IfThenElse(clockwise, p1, p2);
    const VI x[3] = {x0, xOf(q1), xOf(q2)}, y[3] = {y0, yOf(q1), yOf(q2)};

    // The box, as sift() found it.
    const auto firstPixel = [&](const VI* v, std::int32_t offset, std::int32_t border) HWY_ATTR {
      const VI low = hn::Min(v[0], hn::Min(v[1], v[2]));
      return hn::Max(
          hn::ShiftRight<kSubpixelBits>(hn::Add(low, hn::Set(d, kSubpixels - 1 - offset))),
          hn::Set(d, border));
    };
    const auto lastPixel = [&](const VI* v, std::int32_t offset, std::int32_t border) HWY_ATTR {
      const VI high = hn::Max(v[0], hn::Max(v[1], v[2]));
      return hn::Min(hn::ShiftRight<kSubpixelBits>(hn::Sub(high, hn::Set(d, offset))),
                     hn::Set(d, border));
    };
    const std::int32_t left = target_.pixels.x0 - baseX_, bottom = target_.pixels.y0 - baseY_;
    const VI fromX = firstPixel(x, target_.highest.x, left);
    const VI fromY = firstPixel(y, target_.highest.y, target_.rows.first - baseY_);
    const VI spanX = hn::IfThenElseZero(
        drawn, hn::Sub(lastPixel(x, target_.lowest.x, target_.pixels.x1 - 1 - baseX_), fromX));
    const VI spanY = hn::IfThenElseZero(
        drawn, hn::Sub(lastPixel(y, target_.lowest.y, target_.rows.end - 1 - baseY_), fromY));
    const VI one = hn::Set(d, 1);
    const VI count = hn::IfThenElseZero(drawn, hn::Mul(hn::Add(spanX, one), hn::Add(spanY, one)));
    const std::int32_t most = hn::GetLane(hn::MaxOfLanes(d, count));

    // Edge values at the lower left corner of the box's first pixel, less the smallest inside.
    VI corner[3], dx[3], dy[3], least[3], toNextPixel[3], toNextRow[3];
    for (int i = 0; i < 3; ++i) {
      const int from = (i + 1) % 3, to = (i + 2) % 3;
      dx[i] = hn::Sub(x[to], x[from]);
      dy[i] = hn::Sub(y[to], y[from]);
      const auto topLeft =
          hn::Or(hn::Lt(dy[i], zero), hn::And(hn::Eq(dy[i], zero), hn::Lt(dx[i], zero)));
      least[i] = hn::IfThenZeroElse(topLeft, hn::Set(d, 1));
      const VI px = hn::ShiftLeft<kSubpixelBits>(fromX), py = hn::ShiftLeft<kSubpixelBits>(fromY);
      corner[i] = hn::Sub(
          hn::Sub(hn::Mul(dx[i], hn::Sub(py, y[from])), hn::Mul(dy[i], hn::Sub(px, x[from]))),
          least[i]);
      toNextPixel[i] = hn::Neg(hn::ShiftLeft<kSubpixelBits>(dy[i]));
      toNextRow[i] = hn::Add(hn::ShiftLeft<kSubpixelBits>(dx[i]),
                             hn::Mul(hn::ShiftLeft<kSubpixelBits>(dy[i]), spanX));
    }
    const VI nextRow = hn::Sub(hn::Set(d, kTileSide), spanX);

    const auto depthOf = [&](VI i) HWY_ATTR {
      alignas(64) std::int32_t at[kMaxLanes];
      hn::Store(i, d, at);
      return gatherLanes(df, depth_, at);
    };
    const VF z0 = depthOf(i0), zb = depthOf(i1), zc = depthOf(i2);
    const auto clockwiseF = hn::RebindMask(df, clockwise);
    const VF inverse = hn::Div(hn::Set(df, 1.0f), hn::ConvertTo(df, hn::Abs(area)));
    const VF z1 = hn::Mul(hn::Sub(hn::IfThenElse(clockwiseF, zc, zb), z0), inverse);
    const VF z2 = hn::Mul(hn::Sub(hn::IfThenElse(clockwiseF, zb, zc), z0), inverse);

    const VI firstIndex =
        hn::Add(hn::Mul(hn::Sub(fromY, hn::Set(d, bottom)), hn::Set(d, kTileSide)),
                hn::Sub(fromX, hn::Set(d, left)));
    const auto owner = hn::Or(hn::Set(du, TileOwner::make(slot_, 0)),
                              hn::ShiftRight<24>(hn::BitCast(du, triangle)));

    std::size_t waiting = target_.countWaiting();
    for (std::size_t s = 0; s < target_.offsets.size(); ++s) {
      const VI offsetX = hn::Set(d, target_.offsets[s].x),
               offsetY = hn::Set(d, target_.offsets[s].y);
      const auto start = [&](int i) HWY_ATTR {
        return hn::Add(corner[i], hn::Sub(hn::Mul(dx[i], offsetY), hn::Mul(dy[i], offsetX)));
      };
      // Each lane goes through its own box: a wide one and a high one in a vector take no longer
      // than one of them.
      VI e0 = start(0), e1 = start(1), e2 = start(2), index = firstIndex, column = spanX;
      for (std::int32_t pixel = 0; pixel < most; ++pixel) {
        const auto inBox = hn::Gt(count, hn::Set(d, pixel));
        const auto covered = hn::And(inBox, hn::Gt(hn::Or(e0, hn::Or(e1, e2)), hn::Set(d, -1)));
        // Not asked whether any is: the answer is not to be foreseen, and costs more than the rest.
        const VF v1 = hn::ConvertTo(df, hn::Add(e1, least[1]));
        const VF v2 = hn::ConvertTo(df, hn::Add(e2, least[2]));
        const VF z = hn::Add(z0, hn::Add(hn::Mul(v1, z1), hn::Mul(v2, z2)));
        waiting = target_.takeEach(s, covered, z, index, owner, waiting);
        const auto endsRow = hn::Eq(column, zero);
        e0 = hn::Add(e0, hn::IfThenElse(endsRow, toNextRow[0], toNextPixel[0]));
        e1 = hn::Add(e1, hn::IfThenElse(endsRow, toNextRow[1], toNextPixel[1]));
        e2 = hn::Add(e2, hn::IfThenElse(endsRow, toNextRow[2], toNextPixel[2]));
        index = hn::Add(index, hn::IfThenElse(endsRow, nextRow, one));
        column = hn::IfThenElse(endsRow, spanX, hn::Sub(column, one));
      }
    }
    target_.setWaiting(waiting);
  }

  /// Draws one triangle, a vector of pixels at a time.
  void drawMany(std::uint32_t triangle) const
  {
    SmallTriangle corners;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t i = triangle >> (8 * k) & (kMaxClusterVertices - 1);
      corners.x[k] = (packed_[i] & 0xFFFF) + (baseX_ << kSubpixelBits);
      corners.y[k] = (packed_[i] >> 16) + (baseY_ << kSubpixelBits);
      corners.depth[k] = depth_[i];
    }
    drawOriented(corners, instance_, TileOwner::make(slot_, numberOf(triangle)), target_);
  }

  static constexpr hn::ScalableTag<std::uint32_t> du{};

  const Instance& instance_;
  const ClusteredMesh& mesh_;
  const ClusterBounds& bounds_;
  std::uint32_t slot_;
  const Target& target_;
  std::int32_t baseX_, baseY_;  ///< whole pixels
  alignas(64) std::int32_t packed_[kMaxClusterVertices];
  alignas(64) float depth_[kMaxClusterVertices];
  alignas(64) std::uint8_t pixelX_[kMaxClusterVertices], pixelY_[kMaxClusterVertices];
};

#endif  // HWY_TARGET != HWY_SCALAR

/// The blocks of a tile that a box of pixels meets, as a mask.
struct BlockRange {
  int x0, y0, x1, y1;  ///< last ones included

  BlockRange(const ClusterBounds& bounds, const TileRectangle& pixels)
      : x0(std::max(bounds.x0 - pixels.x0, 0) / kBlockSide),
        y0(std::max(bounds.y0 - pixels.y0, 0) / kBlockSide),
        x1((std::min<int>(bounds.x1, pixels.x1) - 1 - pixels.x0) / kBlockSide),
        y1((std::min<int>(bounds.y1, pixels.y1) - 1 - pixels.y0) / kBlockSide)
  {
  }
  std::uint64_t mask() const
  {
    const std::uint64_t row = ((std::uint64_t{2} << x1) - (std::uint64_t{1} << x0)) & 0xFF;
    std::uint64_t bits = 0;
    for (int y = y0; y <= y1; ++y)
      bits |= row << (y * kBlocksPerRow);
    return bits;
  }
};

/// Whether all that a cluster can show lies behind what the tile shows already.
bool isOccluded(const ClusterBounds& bounds, const BlockRange& blocks, std::size_t samples,
                VisibilityTile& tile)
{
  for (int y = blocks.y0; y <= blocks.y1; ++y)
    for (int x = blocks.x0; x <= blocks.x1; ++x) {
      if (!isBehindBlock(bounds.nearest, samples, y * kBlocksPerRow + x, tile)) return false;
    }
  return true;
}

template <class Target>
void drawCluster(const TileCluster& cluster, std::uint32_t slot, const Target& target)
{
#if HWY_TARGET != HWY_SCALAR
  const ClusterBounds& bounds = cluster.bounds;
  constexpr int kSmallPixels = kSmallBox / kSubpixels;
  // Left of the frame and below it differences from the bounds' corner could be rounded.
  if (target.clusters.scene->optimizations.smallClusters && bounds.isWhole && bounds.x0 >= 0 &&
      bounds.y0 >= 0 && bounds.x1 - bounds.x0 < kSmallPixels &&
      bounds.y1 - bounds.y0 < kSmallPixels) {
    SmallCluster<Target>(cluster, slot, target).draw();
    return;
  }
#endif
  ScreenVertices screen;
  transformVertices(cluster.cluster, screen);
  drawAnyCluster(cluster.cluster, screen, slot, target);
}

void prefetch(const TileCluster& cluster)
{
  const ClusteredMesh& mesh = cluster.cluster.mesh();
  const auto fetch = [](const auto* from, std::size_t count) {
    constexpr std::size_t kLine = 64;
    const auto* bytes = reinterpret_cast<const char*>(from);
    const std::size_t size = count * sizeof *from;
    for (std::size_t i = 0; i < size; i += kLine)
      hwy::Prefetch(bytes + i);
    hwy::Prefetch(bytes + size - 1);
  };
  for (const Array<float>* axis : {&mesh.x, &mesh.y, &mesh.z})
    fetch(axis->data() + cluster.bounds.firstVertex, cluster.bounds.vertexCount);
  for (const Array<std::uint8_t>& corner : mesh.corner)
    fetch(corner.data() + cluster.bounds.firstTriangle, cluster.bounds.triangleCount);
}

TileTarget targetOf(const TileClusters& clusters, const TileRectangle& pixels, TileRows rows,
                    int samples, VisibilityTile& tile)
{
  const Span<const SampleOffset> offsets = samplePositions(samples);
  SampleOffset lowest = offsets[0], highest = offsets[0];
  for (const SampleOffset& offset : offsets) {
    lowest = {std::min(lowest.x, offset.x), std::min(lowest.y, offset.y)};
    highest = {std::max(highest.x, offset.x), std::max(highest.y, offset.y)};
  }
  return {clusters, pixels, rows, offsets, lowest, highest, tile};
}

std::size_t rasterizeTileKernel(const TileClusters& clusters, const TileRectangle& pixels,
                                int samples, VisibilityTile& tile)
{
  const OpaqueTarget target(targetOf(clusters, pixels, {pixels.y0, pixels.y1}, samples, tile));
  const bool culls = clusters.scene->optimizations.occlusionCulling;
  const std::size_t count = clusters.list.size();
  const auto isVisible = [&](std::size_t slot) {
    const ClusterBounds& bounds = clusters.list[slot].bounds;
    return !culls || !isOccluded(bounds, BlockRange(bounds, pixels), target.offsets.size(), tile);
  };
  // The next cluster's data comes from memory while one is drawn.
  const auto nextVisible = [&](std::size_t slot) {
    while (slot < count && !isVisible(slot))
      ++slot;
    if (slot < count) prefetch(clusters.list[slot]);
    return slot;
  };
  std::size_t drawn = 0;
  for (std::size_t slot = nextVisible(0); slot < count;) {
    const std::size_t next = nextVisible(slot + 1);
    drawCluster(clusters.list[slot], static_cast<std::uint32_t>(slot), target);
    target.noteDrawn(BlockRange(clusters.list[slot].bounds, pixels).mask());
    ++drawn;
    slot = next;
  }
  return count - drawn;
}

void rasterizeTranslucentKernel(const TileClusters& clusters, std::size_t firstSlot,
                                const TileRectangle& pixels, TileRows rows, int samples,
                                VisibilityTile& tile, TranslucentTile& translucent)
{
  static_assert(kMaxLanes <= static_cast<std::int32_t>(TranslucentTile::kMostMixed),
                "as many triangles as there are lanes come mixed");
  const TranslucentTarget target(targetOf(clusters, pixels, rows, samples, tile), translucent);
  const bool culls = clusters.scene->optimizations.occlusionCulling;
  for (std::size_t slot = firstSlot; slot < clusters.list.size(); ++slot) {
    const ClusterBounds& bounds = clusters.list[slot].bounds;
    if (bounds.y1 <= rows.first || bounds.y0 >= rows.end) continue;
    if (culls && isOccluded(bounds, BlockRange(bounds, pixels), target.offsets.size(), tile))
      continue;
    drawCluster(clusters.list[slot], static_cast<std::uint32_t>(slot), target);
    if (translucent.isOverfull()) return;
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
