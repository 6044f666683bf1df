// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/CastShadows.h"

#include "Rendering/Lines/FirstMet.h"
#include "Rendering/Lines/MendBorder.h"
#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Base/Power.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace limn {
namespace {

constexpr std::size_t kCastersPerTask = 32;

/// The part of an edge that a cone holds.
bool clipToCone(const LightRays& light, Vec3d a, Vec3d b, double& low, double& high)
{
  low = 0;
  high = 1;
  if (!light.isCone) return true;
  const auto at = [&](double u) { return a + (b - a) * u; };
  const auto depth = [&](double u) {
    const Vec3d way = at(u) - light.source;
    return dot(way, light.axis) - light.cosine * std::sqrt(dot(way, way));
  };
  constexpr int kHalvings = 60;
  double best = light.holds(a) ? 0.0 : 1.0;
  if (!light.holds(a) && !light.holds(b)) {
    double left = 0, right = 1;
    for (int i = 0; i < kHalvings; ++i) {
      const double p = left + (right - left) / 3, q = right - (right - left) / 3;
      (depth(p) < depth(q) ? left : right) = depth(p) < depth(q) ? p : q;
    }
    best = 0.5 * (left + right);
    if (!light.holds(at(best))) return false;
  }
  const auto border = [&](double outside) {
    double inside = best;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (inside + outside);
      (light.holds(at(middle)) ? inside : outside) = middle;
    }
    return inside;
  };
  if (!light.holds(a)) low = border(0);
  if (!light.holds(b)) high = border(1);
  return low < high;
}

class ShadowFinder {
 public:
  ShadowFinder(const WorldMesh& world, const TriangleTree& tree, const LightRays& light,
               Span<const double> creaseDegrees)
      : world_(world), tree_(tree), light_(light)
  {
    for (const double degrees : creaseDegrees)
      cosine_.push_back(cosineOfDegrees(degrees));
  }

  void cast(const ShadowCaster& caster, std::uint32_t number, std::vector<ShadowPiece>& pieces)
  {
    const HalfPlane plane(light_, caster.end[0], caster.end[1], world_.size);
    double low, high;
    if (!plane.isProper() || !clipToCone(light_, caster.end[0], caster.end[1], low, high)) return;
    for (int k = 0; k < 2; ++k)
      own_[k] = caster.reach > 0 ? normal(caster.triangle[k]) : Vec3d{0, 0, 0};
    gather(caster, plane, low, high);
    const auto choose = [&](const std::vector<std::uint32_t>& there, const auto& isWayOutBehind) {
      return firstMet(caster, there, isWayOutBehind);
    };
    if (front_.isAllDark()) return;
    std::sort(slices_.begin(), slices_.end(),
              [](const Slice& a, const Slice& b) { return a.triangle < b.triangle; });
    firstMet_.look(slices_, front_, plane.apart());
    firstMet_.find(choose, stretches_);
    for (const Stretch& stretch : stretches_)
      add(number, plane, stretch, pieces);
  }

 private:
  Vec3d normal(std::uint32_t triangle) const
  {
    const Vec3d p = world_.corner(triangle, 0);
    return normalized(cross(world_.corner(triangle, 1) - p, world_.corner(triangle, 2) - p));
  }

  /// What the half plane has of triangles, but for those at the caster and what
  /// light does not come to.
  void gather(const ShadowCaster& caster, const HalfPlane& plane, double low, double high)
  {
    slices_.clear();
    front_.start(low, high);
    const auto isAt = [&](std::uint32_t t) {
      return caster.isContour() ? t == caster.triangle[0]
                                : has(t, caster.point[0]) && has(t, caster.point[1]);
    };
    // As in FirstMet::dropHidden(), for what rounding does.
    const double apart = 2 * plane.apart();
    using Turn = TriangleTree::Turn;
    const auto turnOf = [&](const Box& box) {
      HalfPlane::Extent extent;
      if (front_.isAllDark() || !plane.meets(box, extent)) return Turn::kNever;
      const auto light = front_.lightAt(extent, apart);
      if (light == LightFront::Light::kIsDark) return Turn::kNever;
      if (light == LightFront::Light::kEndsBefore && !mayBeNear(caster, box)) return Turn::kNever;
      // First what may keep all light from the caster: nothing else counts then.
      return extent.most < 0 ? Turn::kLater : Turn::kNow;
    };
    tree_.visitInTurn(
        turnOf, [&](const Box& a, const Box& b) { return plane.isBefore(a, b); },
        [&](std::uint32_t t) {
          Slice slice;
          if (isAt(t) || !cut(plane, t, low, high, slice)) return;
          judge(caster, plane, slice);
          front_.add(slice);
          slices_.push_back(slice);
        },
        later_);
  }
  /// Whether something in a box may lie within the caster's reach.
  bool mayBeNear(const ShadowCaster& caster, const Box& box) const
  {
    if (!(caster.reach > 0)) return false;
    const double reach = caster.reach * (1 + 1e-9) + 1e-9 * world_.size;
    const auto isFar = [&](double a, double b, double low, double high) {
      return std::min(a, b) - high > reach || low - std::max(a, b) > reach;
    };
    const Vec3d a = caster.end[0], b = caster.end[1];
    return !isFar(a.x, b.x, box.low.x, box.high.x) && !isFar(a.y, b.y, box.low.y, box.high.y) &&
           !isFar(a.z, b.z, box.low.z, box.high.z);
  }
  bool has(std::uint32_t triangle, std::uint32_t point) const
  {
    const auto& v = world_.triangles[triangle].vertex;
    return v[0] == point || v[1] == point || v[2] == point;
  }
  void judge(const ShadowCaster& caster, const HalfPlane& plane, Slice& slice) const
  {
    const std::uint32_t t = slice.triangle;
    slice.isOwn = caster.reach > 0 && world_.body[t] == caster.body;
    slice.isNear = slice.isMatch = false;
    slice.endsLight = !slice.isOwn;
    if (!slice.isOwn) return;
    const Vec3d own = normal(t);
    const bool showsOut = dot(own, light_.towardLight(world_.corner(t, 0))) > 0;
    slice.isMatch = showsOut == caster.bulgesOut;
    const double u = 0.5 * (slice.u0 + slice.u1);
    const Vec3d way = plane.point(u, slice.at(u)) - plane.point(u, 0);
    slice.isNear =
        dot(way, way) <= caster.reach * caster.reach &&
        (dot(own, own_[0]) >= cosine_[caster.body] || dot(own, own_[1]) >= cosine_[caster.body]);
    slice.endsLight = !slice.isNear &&
                      (isBeforeCaster(slice) || slice.isMatch || world_.isClosed[caster.body] == 0);
  }
  static bool isBeforeCaster(const Slice& slice) { return 0.5 * (slice.w0 + slice.w1) >= 0; }

  /// What the light meets first, of those in its way.
  template <class IsWayOutBehind>
  std::uint32_t firstMet(const ShadowCaster& caster, const std::vector<std::uint32_t>& there,
                         const IsWayOutBehind& isWayOutBehind) const
  {
    bool isFirst = caster.isContour();
    for (std::size_t i = 0; i < there.size(); ++i) {
      const Slice& slice = slices_[there[i]];
      if (slice.endsLight) return there[i];
      if (isBeforeCaster(slice)) {
        // Facets may stand a little in the way of light that comes along the right side of theirs.
        if (isFirst && !slice.isMatch) return there[i];
        isFirst = false;
      } else if (slice.isMatch && !leaves(there, i) && !isWayOutBehind()) {
        return there[i];
      }
    }
    return kNoSlice;
  }
  /// Whether the ray goes out again soon after.
  bool leaves(const std::vector<std::uint32_t>& there, std::size_t i) const
  {
    return std::any_of(there.begin() + static_cast<std::ptrdiff_t>(i) + 1, there.end(),
                       [&](std::uint32_t other) { return slices_[other].isWayOut(); });
  }

  bool cut(const HalfPlane& plane, std::uint32_t t, double low, double high, Slice& slice) const
  {
    const auto& v = world_.triangles[t].vertex;
    double side[3];
    for (int k = 0; k < 3; ++k)
      side[k] = plane.side(world_.points[v[k]]);
    Vec3d cuts[3];
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const int next = k == 2 ? 0 : k + 1;
      if ((side[k] >= 0) == (side[next] >= 0)) continue;
      // From the lower point on, so that neighbours have the same.
      const int from = v[k] < v[next] ? k : next, to = from == k ? next : k;
      const Vec3d p = world_.points[v[from]], q = world_.points[v[to]];
      cuts[count++] = p + (q - p) * (side[from] / (side[from] - side[to]));
    }
    if (count != 2) return false;
    slice.triangle = t;
    return plane.slice(cuts[0], cuts[1], low, high, slice);
  }

  void add(std::uint32_t number, const HalfPlane& plane, Stretch stretch,
           std::vector<ShadowPiece>& pieces) const
  {
    const Slice& slice = slices_[stretch.slice];
    const double limit = -plane.contact();
    const double w0 = slice.at(stretch.u0), w1 = slice.at(stretch.u1);
    if (!(w0 < limit) && !(w1 < limit)) return;
    if (!(w0 < limit) || !(w1 < limit)) {
      const double u =
          slice.u0 + (slice.u1 - slice.u0) * ((limit - slice.w0) / (slice.w1 - slice.w0));
      (w0 < limit ? stretch.u1 : stretch.u0) = u;
    }
    if (!(stretch.u1 - stretch.u0 > kShadowSliver)) return;
    pieces.push_back({number, slice.triangle, stretch.u0, stretch.u1,
                      plane.point(stretch.u0, slice.at(stretch.u0)),
                      plane.point(stretch.u1, slice.at(stretch.u1))});
  }

  const WorldMesh& world_;
  const TriangleTree& tree_;
  const LightRays& light_;
  std::vector<double> cosine_;             ///< by body
  Vec3d own_[2] = {{0, 0, 0}, {0, 0, 0}};  ///< normals of the caster's faces
  std::vector<std::uint32_t> later_;
  LightFront front_;
  std::vector<Slice> slices_;
  FirstMet firstMet_;
  std::vector<Stretch> stretches_;
};

/// Gives ends of pieces that meet one number.
class BorderBuilder {
 public:
  BorderBuilder(const WorldMesh& world, const LightRays& light, Span<const ShadowCaster> casters,
                BorderPieces& border)
      : world_(world),
        light_(light),
        casters_(casters),
        near_(kShadowContact * world.size),
        border_(border)
  {
  }

  void add(const ShadowPiece& piece)
  {
    const bool goesOn = before_ != nullptr && before_->caster == piece.caster &&
                        piece.u0 - before_->u1 <= kShadowSliver && areNear(piece.from, before_->to);
    const std::uint32_t from = goesOn                      ? last_
                               : piece.u0 <= kShadowSliver ? atEnd(piece, 0, piece.from)
                                                           : add(piece.from, piece);
    last_ = piece.u1 >= 1 - kShadowSliver ? atEnd(piece, 1, piece.to) : add(piece.to, piece);
    before_ = &piece;
    border_.links.push_back({from, last_, piece.receiver});
  }

 private:
  bool showsOut(std::uint32_t t) const
  {
    const Vec3d a = world_.corner(t, 0);
    return dot(cross(world_.corner(t, 1) - a, world_.corner(t, 2) - a), light_.towardLight(a)) > 0;
  }
  bool areNear(Vec3d a, Vec3d b) const { return dot(a - b, a - b) <= near_ * near_; }
  std::uint32_t add(Vec3d p, const ShadowPiece& piece)
  {
    border_.points.push_back(p);
    border_.receiver.push_back(piece.receiver);
    border_.reach.push_back(casters_[piece.caster].gap);
    border_.isOfContour.push_back(casters_[piece.caster].isContour() ? 1 : 0);
    border_.showsOut.push_back(showsOut(piece.receiver) ? 1 : 0);
    return static_cast<std::uint32_t>(border_.points.size() - 1);
  }
  /// What other casters at that end of the caster cast there.
  std::uint32_t atEnd(const ShadowPiece& piece, int end, Vec3d p)
  {
    std::vector<std::uint32_t>& there = cast_[casters_[piece.caster].place[end]];
    for (const std::uint32_t point : there)
      if (areNear(border_.points[point], p)) return point;
    there.push_back(add(p, piece));
    return there.back();
  }

  const WorldMesh& world_;
  const LightRays& light_;
  Span<const ShadowCaster> casters_;
  double near_;
  BorderPieces& border_;
  std::map<std::uint64_t, std::vector<std::uint32_t>> cast_;  ///< by place of casters
  const ShadowPiece* before_ = nullptr;
  std::uint32_t last_ = 0;
};

/// A point of a facet in the triangle as it is drawn.
Vec3d drawnPoint(const RefinedWorld& world, Vec3d p, std::uint32_t t)
{
  const WorldMesh& mesh = world.mesh;
  if (world.fineness[mesh.body[t]] == 1) return p;
  const Vec3d a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
  const Vec3d n = cross(b - a, c - a);
  const double area = dot(n, n);
  if (!(area > 0)) return p;
  const double v = dot(cross(p - a, c - a), n) / area, w = dot(cross(b - a, p - a), n) / area;
  const auto& number = mesh.triangles[t].vertex;
  const Vec3d drawn = world.flat[number[0]];
  return drawn + ((world.flat[number[1]] - drawn) * v + (world.flat[number[2]] - drawn) * w);
}

/// The normal of what is drawn for a facet, towards the side that its light comes from.
Vec3d litSideOf(const RefinedWorld& world, const LightRays& light, std::uint32_t t)
{
  const WorldMesh& mesh = world.mesh;
  const auto& v = mesh.triangles[t].vertex;
  const Vec3d a = mesh.points[v[0]];
  const Vec3d facet = cross(mesh.points[v[1]] - a, mesh.points[v[2]] - a);
  const Vec3d drawn =
      cross(world.flat[v[1]] - world.flat[v[0]], world.flat[v[2]] - world.flat[v[0]]);
  return dot(facet, light.towardLight(a)) < 0 ? -drawn : drawn;
}

}  // namespace

std::vector<ShadowPiece> shadowPieces(const WorldMesh& world, const TriangleTree& tree,
                                      const LightRays& light, Span<const ShadowCaster> casters,
                                      Span<const double> creaseDegrees, int threads)
{
  std::vector<std::vector<ShadowPiece>> found(stretchCount(casters.size(), kCastersPerTask));
  parallelForStretches(threads, casters.size(), kCastersPerTask,
                       [&](std::size_t task, std::size_t first, std::size_t end) {
                         ShadowFinder finder(world, tree, light, creaseDegrees);
                         for (std::size_t c = first; c < end; ++c)
                           finder.cast(casters[c], static_cast<std::uint32_t>(c), found[task]);
                       });
  std::vector<ShadowPiece> pieces;
  for (const std::vector<ShadowPiece>& some : found)
    pieces.insert(pieces.end(), some.begin(), some.end());
  return pieces;
}

ShadowLines shadowBorder(const RefinedWorld& world, Span<const ShadowCaster> casters,
                         Span<const ShadowPiece> pieces, const LightRays& light, std::size_t body,
                         const Mat4d& worldToModel)
{
  BorderPieces border;
  BorderBuilder builder(world.mesh, light, casters, border);
  for (const ShadowPiece& piece : pieces)
    if (casters[piece.caster].body == body) builder.add(piece);
  mendBorder(casters, border);
  ShadowLines shadow;
  for (std::size_t i = 0; i < border.points.size(); ++i)
    shadow.lines.points.push_back(
        transformPoint(worldToModel, drawnPoint(world, border.points[i], border.receiver[i])));
  std::vector<std::uint32_t> receiver;
  chainLinks(border.links, shadow.lines.points.size(), shadow.lines.chains, &receiver);
  for (const std::uint32_t t : receiver)
    shadow.litSide.push_back(t == kNoCorner ? Vec3d{0, 0, 0} : litSideOf(world, light, t));
  return shadow;
}

bool concealBehindSheets(const ShadowLines& shadow, const Camera& camera, const Mat4d& modelToWorld,
                         std::vector<std::uint8_t>& flags)
{
  const ModelEye eye(camera, Mat4d::identity());
  const LineChains& chains = shadow.lines.chains;
  flags.assign(chains.vertex.size(), 0);
  bool isAny = false;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    const Vec3d p = transformPoint(modelToWorld, shadow.lines.points[chains.vertex[i]]);
    if (!(dot(shadow.litSide[i], eye.toward(p)) < 0)) continue;
    flags[i] = kConcealedLine;
    isAny = true;
  }
  return isAny;
}

}  // namespace limn
