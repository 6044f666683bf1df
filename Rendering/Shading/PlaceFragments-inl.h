// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by PlaceFragments.cpp.
#include "Rendering/Base/Gather-inl.h"
#include "Rendering/Base/Simd.h"
#include "Rendering/Vertex/ScreenLanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Arrays as vectors of lanes see them, gathered by index.
class Gatherer {
 public:
  using DF = hn::ScalableTag<float>;
  using DI = hn::ScalableTag<std::int32_t>;
  using VI = hn::Vec<DI>;

  Gatherer(const TileClusters& clusters, const PlacedInstance& placed, FragmentBatch& batch)
      : clusters_(clusters),
        mesh_(placed.mesh()),
        data_(placed.instance->attributes),
        normals_(placed.instance->style.normals),
        splitNormals_(normals_ == NormalSource::kVertex && !data_.normalOfCorner.empty()),
        readsAlpha_(placed.instance->style.readsAlpha),
        uv_(*placed.instance),
        smoothLevels_(smoothLevelsOf(*placed.instance)),
        batch_(batch)
  {
  }

  /// In steps over all of the batch, as each waits for memory at numbers that the last one read.
  void gather()
  {
    const auto count = static_cast<std::size_t>(batch_.count);
    for (std::size_t i = 0; i < count; i += hn::Lanes(DI()))
      findCorners(i);
    const bool readsVertices = normals_ == NormalSource::kVertex || !data_.vertexColors.empty() ||
                               uv_.any() || smoothLevels_ > 0;
    for (std::size_t i = 0; readsVertices && i < count; i += hn::Lanes(DI()))
      findVertices(i);
    for (std::size_t i = 0; i < count; i += hn::Lanes(DI()))
      for (int k = 0; k < 3; ++k)
        gatherPositions(k, i);
    for (std::size_t i = 0; readsVertices && i < count; i += hn::Lanes(DI()))
      for (int k = 0; k < 3; ++k)
        gatherVertexData(k, i);
    if (smoothLevels_ > 0) gatherSmoothNormals(count);
    const bool cellColors = data_.vertexColors.empty() && !data_.cellColors.empty();
    if (!cellColors && normals_ != NormalSource::kCell) return;
    for (std::size_t i = 0; i < count; i += hn::Lanes(DI())) {
      const VI triangle = indices(mesh_.triangle.data(), hn::Load(DI(), place_ + i));
      const VI cell = data_.cells.empty() ? triangle : indices(data_.cells.data(), triangle);
      if (cellColors) storeColor(data_.cellColors.data(), cell, 0, i);
      if (normals_ != NormalSource::kCell) continue;
      hn::Store(cell, DI(), normal_[0] + i);
      storeVectors(data_.cellNormals, normal_[0] + i, batch_.cornerNormal[0], i);
    }
  }

 private:
  /// Places of the triangles and of their corners in the mesh.
  void findCorners(std::size_t i)
  {
    const VI owner = hn::BitCast(DI(), hn::Load(hn::RebindToUnsigned<DI>(), batch_.owner + i));
    const VI number = hn::And(owner, hn::Set(DI(), (1 << TileOwner::kTriangleBits) - 1));
    constexpr int kStride = sizeof(TileCluster) / sizeof(std::int32_t);
    hn::Store(hn::Mul(hn::ShiftRight<TileOwner::kTriangleBits>(owner), hn::Set(DI(), kStride)),
              DI(), place_ + i);
    const VI firstVertex = indices(&clusters_.list[0].bounds.firstVertex, place_ + i);
    const VI firstTriangle = indices(&clusters_.list[0].bounds.firstTriangle, place_ + i);
    hn::Store(hn::Add(firstTriangle, number), DI(), place_ + i);
    for (int k = 0; k < 3; ++k) {
      const VI corner = gatherBytes(DI(), mesh_.corner[k].data(), place_ + i);
      hn::Store(hn::Add(firstVertex, corner), DI(), corner_[k] + i);
    }
  }
  /// Numbers of the corners in the caller's mesh, and of their normals.
  void findVertices(std::size_t i)
  {
    for (int k = 0; k < 3; ++k) {
      const VI vertex = indices(mesh_.vertex.data(), corner_[k] + i);
      hn::Store(vertex, DI(), vertex_[k] + i);
      if (normals_ != NormalSource::kVertex) continue;
      hn::Store(splitNormals_ ? ofCorners(data_.normalOfCorner, k, i) : vertex, DI(),
                normal_[k] + i);
      for (std::size_t lane = 0; lane < hn::Lanes(DI()); ++lane)
        hwy::Prefetch(data_.vertexNormals.data() + normal_[k][i + lane]);
    }
  }
  VI ofCorners(Span<const std::uint32_t> numbers, int k, std::size_t i) const
  {
    const VI triangle = indices(mesh_.triangle.data(), hn::Load(DI(), place_ + i));
    const VI first = hn::Add(triangle, hn::Add(triangle, triangle));
    return indices(numbers.data(), hn::Add(first, hn::Set(DI(), k)));
  }
  HWY_INLINE void gatherPositions(int k, std::size_t i) const
  {
    const std::int32_t* const at = corner_[k] + i;
    const auto store = [&](const Array<float>& from, float* to) HWY_ATTR {
      hn::Store(gatherLanes(DF(), from.data(), at), DF(), to + i);
    };
    store(mesh_.x, batch_.corner[k].x);
    store(mesh_.y, batch_.corner[k].y);
    store(mesh_.z, batch_.corner[k].z);
    if (!mesh_.hasLowParts()) return;
    store(mesh_.xLow, batch_.cornerLow[k].x);
    store(mesh_.yLow, batch_.cornerLow[k].y);
    store(mesh_.zLow, batch_.cornerLow[k].z);
  }
  HWY_INLINE void gatherVertexData(int k, std::size_t i) const
  {
    const VI vertex = hn::Load(DI(), vertex_[k] + i);
    if (normals_ == NormalSource::kVertex)
      storeVectors(data_.vertexNormals, normal_[k] + i, batch_.cornerNormal[k], i);
    if (!data_.vertexColors.empty()) storeColor(data_.vertexColors.data(), vertex, k, i);
    if (uv_.set[0]) storePairs(data_.uv.data(), vertex, batch_.cornerUv[0][k], i);
    if (uv_.set[1]) storePairs(data_.uv2.data(), vertex, batch_.cornerUv[1][k], i);
  }
  /// Last of what is read by vertex: it may put other numbers in the place of theirs.
  HWY_NOINLINE void gatherSmoothNormals(std::size_t count)
  {
    for (std::size_t i = 0; !data_.smoothOfCorner.empty() && i < count; i += hn::Lanes(DI()))
      for (int k = 0; k < 3; ++k)
        hn::Store(ofCorners(data_.smoothOfCorner, k, i), DI(), vertex_[k] + i);
    const auto* const from = reinterpret_cast<const std::int32_t*>(data_.smoothNormals.data());
    for (std::size_t i = 0; i < count; i += hn::Lanes(DI()))
      for (int k = 0; k < 3; ++k)
        for (int level = 0; level < smoothLevels_; ++level) {
          const std::int32_t* const index = vertex_[k] + i;
          const auto placeOf = [&](std::size_t lane) {
            return std::ptrdiff_t{smoothLevels_} * index[lane] + level;
          };
          const auto places = [&]() HWY_ATTR {
            return hn::Add(hn::Mul(hn::Load(DI(), index), hn::Set(DI(), smoothLevels_)),
                           hn::Set(DI(), level));
          };
          storeUnpacked(gatherLanes(DI(), from, placeOf, places), batch_.smoothNormal[level][k], i);
        }
  }
  /// unpackedNormal()
  static HWY_INLINE void storeUnpacked(VI packed, FragmentBatch::Vectors& to, std::size_t i)
  {
    const auto unit = hn::Set(DF(), 1.0f / 32767.0f), zero = hn::Zero(DF());
    const auto x =
        hn::Mul(hn::ConvertTo(DF(), hn::ShiftRight<16>(hn::ShiftLeft<16>(packed))), unit);
    const auto y = hn::Mul(hn::ConvertTo(DF(), hn::ShiftRight<16>(packed)), unit);
    const auto z = hn::Sub(hn::Set(DF(), 1.0f), hn::Add(hn::Abs(x), hn::Abs(y)));
    const auto fold = hn::IfThenElseZero(hn::Lt(z, zero), hn::Neg(z));
    const auto unfolded = [&](hn::Vec<DF> v) HWY_ATTR {
      return hn::IfThenElse(hn::Lt(v, zero), hn::Add(v, fold), hn::Sub(v, fold));
    };
    const auto nx = unfolded(x), ny = unfolded(y);
    const auto squared = hn::Add(hn::Add(hn::Mul(nx, nx), hn::Mul(ny, ny)), hn::Mul(z, z));
    const auto inverse =
        hn::IfThenElseZero(hn::Gt(squared, zero), hn::Div(hn::Set(DF(), 1.0f), hn::Sqrt(squared)));
    hn::Store(hn::Mul(nx, inverse), DF(), to.x + i);
    hn::Store(hn::Mul(ny, inverse), DF(), to.y + i);
    hn::Store(hn::Mul(z, inverse), DF(), to.z + i);
  }

  static HWY_INLINE VI indices(const std::uint32_t* from, VI index)
  {
    return hn::GatherIndex(DI(), reinterpret_cast<const std::int32_t*>(from), index);
  }
  static HWY_INLINE VI indices(const std::uint32_t* from, const std::int32_t* index)
  {
    return gatherLanes(DI(), reinterpret_cast<const std::int32_t*>(from), index);
  }

  static HWY_INLINE void storeVectors(Span<const Vec3f> from, const std::int32_t* index,
                                      FragmentBatch::Vectors& to, std::size_t i)
  {
    float* const components[3] = {to.x + i, to.y + i, to.z + i};
    gatherTriples(DF(), &from.data()->x, from.size(), index, components);
  }

  static HWY_INLINE void storePairs(const Vec2f* from, VI index, FragmentBatch::Pairs& to,
                                    std::size_t i)
  {
    const VI first = hn::Add(index, index);
    hn::Store(hn::GatherIndex(DF(), &from->x, first), DF(), to.x + i);
    hn::Store(hn::GatherIndex(DF(), &from->y, first), DF(), to.y + i);
  }

  HWY_INLINE void storeColor(const Rgba8* from, VI index, int k, std::size_t i) const
  {
    FragmentBatch::Vectors& to = batch_.cornerColor[k];
    const VI rgba = hn::GatherIndex(DI(), reinterpret_cast<const std::int32_t*>(from), index);
    const VI byte = hn::Set(DI(), 0xFF);
    hn::Store(hn::ConvertTo(DF(), hn::And(rgba, byte)), DF(), to.x + i);
    hn::Store(hn::ConvertTo(DF(), hn::And(hn::ShiftRight<8>(rgba), byte)), DF(), to.y + i);
    hn::Store(hn::ConvertTo(DF(), hn::And(hn::ShiftRight<16>(rgba), byte)), DF(), to.z + i);
    if (!readsAlpha_) return;
    const VI alpha = hn::And(hn::ShiftRight<24>(rgba), byte);
    hn::Store(hn::ConvertTo(DF(), alpha), DF(), batch_.cornerAlpha[k] + i);
  }

  const TileClusters& clusters_;
  const ClusteredMesh& mesh_;
  const Attributes& data_;
  NormalSource normals_;
  bool splitNormals_, readsAlpha_;
  UvUse uv_;
  int smoothLevels_;
  FragmentBatch& batch_;
  alignas(64) std::int32_t place_[FragmentBatch::kCapacity];
  alignas(64) std::int32_t corner_[3][FragmentBatch::kCapacity];
  alignas(64) std::int32_t vertex_[3][FragmentBatch::kCapacity];
  alignas(64) std::int32_t normal_[3][FragmentBatch::kCapacity];
};

void gatherFragmentsKernel(const TileClusters& clusters, const PlacedInstance& placed,
                           FragmentBatch& batch)
{
  const auto count = static_cast<std::size_t>(batch.count);
  const std::size_t lanes = hn::Lanes(Gatherer::DI());
  for (std::size_t i = count; i % lanes != 0; ++i)
    batch.owner[i] = batch.owner[0];
  Gatherer(clusters, placed, batch).gather();
}

void placeInFloat(const InstanceTransform& transform, FragmentBatch& batch)
{
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const auto count = static_cast<std::size_t>(batch.count);
  auto any = hn::Zero(di);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    auto clip = hn::Zero(di);
    for (int k = 0; k < 3; ++k) {
      const FragmentBatch::Vectors& p = batch.corner[k];
      const auto lanes = screenLanes(d, transform,
                                     clipLanes(d, transform.toClipFloat, hn::Load(d, p.x + i),
                                               hn::Load(d, p.y + i), hn::Load(d, p.z + i)));
      hn::Store(hn::NearestInt(lanes.x), di, batch.screenX[k] + i);
      hn::Store(hn::NearestInt(lanes.y), di, batch.screenY[k] + i);
      hn::Store(lanes.inverseW, d, batch.inverseW[k] + i);
      clip = hn::Or(clip, hn::BitCast(di, hn::VecFromMask(d, lanes.needsClip)));
    }
    hn::Store(clip, di, batch.needsClip + i);
    any = hn::Or(any, clip);
  }
  batch.anyNeedsClip = !hn::AllTrue(di, hn::Eq(any, hn::Zero(di)));
}

void placeInDouble(const InstanceTransform& transform, FragmentBatch& batch)
{
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, decltype(d)> df;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  const bool hasLow = transform.hasLowParts;
  const auto sum = [&](const float* high, const float* low) HWY_ATTR {
    // Adding +0 makes -0 into +0, as the scalar code does.
    const V l = hasLow ? hn::PromoteTo(d, hn::Load(df, low)) : hn::Zero(d);
    return hn::Add(hn::PromoteTo(d, hn::Load(df, high)), l);
  };
  const auto count = static_cast<std::size_t>(batch.count);
  V any = hn::Zero(d);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    V clip = hn::Zero(d), x0 = clip, y0 = clip, z0 = clip;
    for (int k = 0; k < 3; ++k) {
      const FragmentBatch::Vectors &h = batch.corner[k], &l = batch.cornerLow[k];
      const V x = sum(h.x + i, l.x + i), y = sum(h.y + i, l.y + i), z = sum(h.z + i, l.z + i);
      const auto lanes = screenLanes(d, transform, clipLanes(d, transform.toClip, x, y, z));
      hn::Store(hn::DemoteTo(di, hn::Round(lanes.x)), di, batch.screenX[k] + i);
      hn::Store(hn::DemoteTo(di, hn::Round(lanes.y)), di, batch.screenY[k] + i);
      hn::Store(hn::DemoteTo(df, lanes.inverseW), df, batch.inverseW[k] + i);
      clip = hn::Or(clip, hn::IfThenElseZero(lanes.needsClip, hn::Set(d, -1.0)));
      if (!hasLow) continue;
      const auto view = clipLanes(d, transform.toView, x, y, z);
      hn::Store(hn::DemoteTo(df, view.x), df, batch.viewCorner[k].x + i);
      hn::Store(hn::DemoteTo(df, view.y), df, batch.viewCorner[k].y + i);
      hn::Store(hn::DemoteTo(df, view.z), df, batch.viewCorner[k].z + i);
      if (k == 0) {
        x0 = x;
        y0 = y;
        z0 = z;
        continue;
      }
      hn::Store(hn::DemoteTo(df, hn::Sub(x, x0)), df, batch.edge[k - 1].x + i);
      hn::Store(hn::DemoteTo(df, hn::Sub(y, y0)), df, batch.edge[k - 1].y + i);
      hn::Store(hn::DemoteTo(df, hn::Sub(z, z0)), df, batch.edge[k - 1].z + i);
    }
    hn::Store(hn::DemoteTo(di, clip), di, batch.needsClip + i);
    any = hn::Or(any, clip);
  }
  batch.anyNeedsClip = !hn::AllTrue(d, hn::Eq(any, hn::Zero(d)));
}

/// Edge values in double: below 2^50, so every step but the last, to float, is exact.
void weigh(bool mirrored, bool footprint, FragmentBatch& batch)
{
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, decltype(d)> df;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  const auto load = [&](const std::int32_t* from)
                        HWY_ATTR { return hn::PromoteTo(d, hn::Load(di, from)); };
  const auto outside = hn::Set(df, mirrored ? -1.0f : 1.0f);
  const auto count = static_cast<std::size_t>(batch.count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V x[3] = {load(batch.screenX[0] + i), load(batch.screenX[1] + i),
                    load(batch.screenX[2] + i)};
    const V y[3] = {load(batch.screenY[0] + i), load(batch.screenY[1] + i),
                    load(batch.screenY[2] + i)};
    const V px = load(batch.pointX + i), py = load(batch.pointY + i);
    // Twice the area of corners a, b and a point, with a sign; `turned` swaps what is subtracted,
    // so that zero stays +0.
    const auto edge = [&](int a, int b, V atX, V atY, hn::Mask<decltype(d)> turned) HWY_ATTR {
      const V p = hn::Mul(hn::Sub(x[b], x[a]), hn::Sub(atY, y[a]));
      const V q = hn::Mul(hn::Sub(y[b], y[a]), hn::Sub(atX, x[a]));
      return hn::Sub(hn::IfThenElse(turned, q, p), hn::IfThenElse(turned, p, q));
    };
    const auto never = hn::Lt(px, px);
    const auto clockwise = hn::Lt(edge(0, 1, x[2], y[2], never), hn::Zero(d));
    const V e0 = edge(1, 2, px, py, clockwise), e1 = edge(2, 0, px, py, clockwise),
            e2 = edge(0, 1, px, py, clockwise);
    const auto inverseW = [&](int k) HWY_ATTR { return hn::Load(df, batch.inverseW[k] + i); };
    const auto store = [&](V at0, V at1, V at2, float(*weight)[FragmentBatch::kCapacity]) HWY_ATTR {
      const auto s0 = hn::Mul(hn::DemoteTo(df, at0), inverseW(0)),
                 s1 = hn::Mul(hn::DemoteTo(df, at1), inverseW(1)),
                 s2 = hn::Mul(hn::DemoteTo(df, at2), inverseW(2));
      const auto inverse = hn::Div(hn::Set(df, 1.0f), hn::Add(hn::Add(s0, s1), s2));
      hn::Store(hn::Mul(s0, inverse), df, weight[0] + i);
      hn::Store(hn::Mul(s1, inverse), df, weight[1] + i);
      hn::Store(hn::Mul(s2, inverse), df, weight[2] + i);
    };
    store(e0, e1, e2, batch.weight);
    if (footprint) {
      // From pixel to pixel edge values change by whole numbers, exactly.
      const V pixel = hn::IfThenElse(clockwise, hn::Set(d, -double{kSubpixels}),
                                     hn::Set(d, double{kSubpixels}));
      const auto step = [&](V from, V to) HWY_ATTR { return hn::Mul(hn::Sub(to, from), pixel); };
      const auto right = [&](V e, int a, int b) HWY_ATTR { return hn::Add(e, step(y[b], y[a])); };
      const auto above = [&](V e, int a, int b) HWY_ATTR { return hn::Add(e, step(x[a], x[b])); };
      store(right(e0, 1, 2), right(e1, 2, 0), right(e2, 0, 1), batch.rightWeight);
      store(above(e0, 1, 2), above(e1, 2, 0), above(e2, 0, 1), batch.aboveWeight);
    }
    const auto turned = hn::DemoteTo(df, hn::IfThenElseZero(clockwise, hn::Set(d, 1.0)));
    hn::Store(hn::IfThenElse(hn::Gt(turned, hn::Zero(df)), hn::Neg(outside), outside), df,
              batch.side + i);
  }
}

/// From offsets in the pixel to points in the viewport.
void movePoints(const TileRectangle& pixels, FragmentBatch& batch)
{
  const hn::ScalableTag<std::int32_t> d;
  const auto x0 = hn::Set(d, pixels.x0 * kSubpixels), y0 = hn::Set(d, pixels.y0 * kSubpixels);
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); i += hn::Lanes(d)) {
    const auto pixel = hn::Load(d, batch.pixel + i);
    const auto column = hn::And(pixel, hn::Set(d, kTileSide - 1));
    const auto row = hn::ShiftRight<6>(pixel);
    static_assert(kTileSide == 1 << 6, "a row of a tile is a shift");
    const auto x = hn::Add(hn::ShiftLeft<kSubpixelBits>(column), x0);
    const auto y = hn::Add(hn::ShiftLeft<kSubpixelBits>(row), y0);
    hn::Store(hn::Add(hn::Load(d, batch.pointX + i), x), d, batch.pointX + i);
    hn::Store(hn::Add(hn::Load(d, batch.pointY + i), y), d, batch.pointY + i);
  }
}

void placeFragmentsKernel(const InstanceTransform& transform, const TileRectangle& pixels,
                          bool footprint, FragmentBatch& batch)
{
  movePoints(pixels, batch);
  if (transform.precise)
    placeInDouble(transform, batch);
  else
    placeInFloat(transform, batch);
  weigh(transform.mirrored, footprint, batch);
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
