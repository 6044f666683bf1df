// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceOutline.h"

#include "Rendering/Base/Power.h"
#include "Rendering/Base/ResolveTable.h"
#include "Rendering/Vertex/ScreenToView.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace limn::reference {
namespace {

struct Pixel {
  int x, y;
};

constexpr Pixel kBeside[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
constexpr Pixel kAround[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};

/// Part of a border, and which way is out.
struct Edge {
  Vec2f foot, normal;
  Pixel at;             ///< that it runs through, or beside
  std::uint32_t of;     ///< the instance whose surface is bounded
  Pixel shown;          ///< shows that surface
  float part;           ///< of its line's width that lies inside; the rest is the other surface's
  bool isBesideHidden;  ///< beside its pixel the surface may go on unseen
};

struct Segment {
  Vec2f a, b;
  Pixel owner, beyond;  ///< on its two sides
};

float dot2(Vec2f a, Vec2f b)
{
  return a.x * b.x + a.y * b.y;
}

/// The area of the unit square about the origin in which n.x < d.
float areaBelow(Vec2f n, float d)
{
  const float u = std::max(std::fabs(n.x), std::fabs(n.y));
  const float v = std::min(std::fabs(n.x), std::fabs(n.y));
  const float corner = (u + v) * 0.5f, side = (u - v) * 0.5f;
  if (d <= -corner) return 0.0f;
  if (d >= corner) return 1.0f;
  if (std::fabs(d) <= side) return 0.5f + d / u;
  const float rest = corner - std::fabs(d);
  const float cut = rest * rest / (2.0f * u * v);
  return d < 0.0f ? cut : 1.0f - cut;
}

/// d for which areaBelow(n, d) is `area`.
float distanceOf(Vec2f n, float area)
{
  const float u = std::max(std::fabs(n.x), std::fabs(n.y));
  const float v = std::min(std::fabs(n.x), std::fabs(n.y));
  const float corner = (u + v) * 0.5f, side = (u - v) * 0.5f;
  const float middle = (area - 0.5f) * u;
  if (std::fabs(middle) <= side) return middle;
  if (area < 0.5f) return std::sqrt(2.0f * u * v * area) - corner;
  return corner - std::sqrt(2.0f * u * v * (1.0f - area));
}

std::uint8_t roundedByte(float x)
{
  return static_cast<std::uint8_t>(std::nearbyint(std::clamp(x, 0.0f, 255.0f)));
}

class Outlines {
 public:
  Outlines(const Scene& scene, const FrameView& frame, const std::vector<Layer>& layers, int apron)
      : scene_(scene),
        frame_(frame),
        layers_(layers),
        apron_(apron),
        toView_(scene.camera, frame.width, frame.height)
  {
    edges_.resize(layers.size());
    right_.resize(layers.size());
    above_.resize(layers.size());
    isUnited_.resize(layers.size());
    segments_.resize(layers.size());
    forEachPixel([&](Pixel p) { findAt(p); });
    dropSpecks();
    dropShortCreases();
    straightenEnds();
    forEachPixel([&](Pixel p) {
      if (isInside({p.x, p.y + 1})) joinAt(p);
    });
  }

  void draw() const
  {
    for (int y = 0; y < frame_.height; ++y)
      for (int x = 0; x < frame_.width; ++x) {
        const float layers = shareOfLayer({x, y});
        paintRest({x, y}, shareOfRest({x, y}));
        paintLayer({x, y}, layers);
      }
  }

 private:
  std::size_t index(Pixel p) const
  {
    return static_cast<std::size_t>(p.y + apron_) *
               static_cast<std::size_t>(frame_.width + 2 * apron_) +
           static_cast<std::size_t>(p.x + apron_);
  }
  /// Of the frame and the apron, row by row.
  template <class Visit>
  void forEachPixel(Visit visit) const
  {
    for (int y = -apron_; y < frame_.height + apron_; ++y)
      for (int x = -apron_; x < frame_.width + apron_; ++x)
        visit(Pixel{x, y});
  }
  const Layer& layer(Pixel p) const { return layers_[index(p)]; }
  bool isInside(Pixel p) const
  {
    return p.x >= -apron_ && p.y >= -apron_ && p.x < frame_.width + apron_ &&
           p.y < frame_.height + apron_;
  }
  const Style& styleAt(Pixel p) const { return scene_.instances[layer(p).instance].style; }
  bool isOutlined(std::uint32_t instance) const
  {
    if (instance == kNobody) return false;
    const Instance& of = scene_.instances[instance];
    return of.style.imageOutline.detector != OutlineDetector::kNone && of.style.outlineWidth > 0 &&
           !of.isTranslucent();
  }
  float own(Pixel p) const
  {
    return static_cast<float>(layer(p).count) / static_cast<float>(scene_.samples);
  }
  static Vec2f centre(Pixel p)
  {
    return {static_cast<float>(p.x) + 0.5f, static_cast<float>(p.y) + 0.5f};
  }
  float bothTolerances(Pixel p, Pixel q) const
  {
    return std::max(toleranceAt(scene_, layer(p)), toleranceAt(scene_, layer(q)));
  }

  /// Distance from the eye's plane at q if the instance of p is there, else at p.
  float distanceAt(Pixel p, Pixel q) const
  {
    const bool isThere = isInside(q) && layer(q).instance == layer(p).instance;
    return -layer(isThere ? q : p).point.position.z;
  }
  /// Sobel's weights 1, 2, 1 along each axis.
  Vec2f sobel(Pixel p) const
  {
    const auto z = [&](int dx, int dy) { return distanceAt(p, {p.x + dx, p.y + dy}); };
    float gx = 0, gy = 0;
    for (int i = -1; i <= 1; ++i) {
      const float weight = i == 0 ? 2.0f : 1.0f;
      gx = gx + weight * (z(1, i) - z(-1, i));
      gy = gy + weight * (z(i, 1) - z(i, -1));
    }
    return {gx / 8.0f, gy / 8.0f};
  }
  /// What of a gradient there is on the way from p to q, per pixel.
  static float slope(Pixel p, Pixel q, Vec2f gradient)
  {
    const auto dx = static_cast<float>(q.x - p.x), dy = static_cast<float>(q.y - p.y);
    const float along = gradient.x * dx + gradient.y * dy;
    return std::fabs(dx != 0 && dy != 0 ? along * 0.707106781f : along);
  }
  float laplacian(Pixel p) const
  {
    const float sides = distanceAt(p, {p.x + 1, p.y}) + distanceAt(p, {p.x - 1, p.y});
    const float ends = distanceAt(p, {p.x, p.y + 1}) + distanceAt(p, {p.x, p.y - 1});
    return (sides + ends) - 4.0f * distanceAt(p, p);
  }
  /// Between two pixels of one instance.
  bool isEdge(Pixel p, Pixel q) const
  {
    const float tolerance = bothTolerances(p, q);
    switch (styleAt(p).imageOutline.detector) {
      case OutlineDetector::kSobel:
        return std::min(slope(p, q, sobel(p)), slope(p, q, sobel(q))) > tolerance;
      case OutlineDetector::kLaplacian: {
        const float a = laplacian(p), b = laplacian(q);
        const bool turns = (a > 0 && b < 0) || (a < 0 && b > 0);
        return turns && std::fabs(a - b) > 2.0f * tolerance;
      }
      default:
        return arePartedByPlanes(p, q);
    }
  }
  bool arePartedByPlanes(Pixel p, Pixel q) const
  {
    return isStep(layer(p), layer(q), bothTolerances(p, q)) && !isGroove(p, q);
  }
  /// Both are before the other's plane, and the steeper does not bend where it comes to the other.
  bool isGroove(Pixel p, Pixel q) const
  {
    const Vec3f way = layer(q).point.position - layer(p).point.position;
    if (!(dot(layer(p).plane, way) > 0) || !(dot(layer(q).plane, way * -1.0f) > 0)) return false;
    if (isSteeper(p, q)) return isFlat(p, {p.x + p.x - q.x, p.y + p.y - q.y});
    return isFlat(q, {q.x + q.x - p.x, q.y + q.y - p.y});
  }
  bool isSteeper(Pixel p, Pixel q) const
  {
    const Vec3f eye = betweenAndEye(layer(p), layer(q));
    return dot(layer(p).plane, eye) < dot(layer(q).plane, eye);
  }
  Vec3f betweenAndEye(const Layer& a, const Layer& b) const
  {
    return scene_.camera.parallel ? Vec3f{0, 0, 1} : (a.point.position + b.point.position) * -1.0f;
  }
  bool isFlat(Pixel p, Pixel q) const
  {
    return isInside(q) && layer(q).instance == layer(p).instance &&
           1.0f - dot(layer(p).normal, layer(q).normal) <= ImageOutline::kFlat;
  }

  /// Which of two pixels an edge between them belongs to.
  bool ownsEdge(Pixel p, Pixel q) const
  {
    const Layer &a = layer(p), &b = layer(q);
    const bool isSame = a.instance == b.instance;
    const Vec3f way = b.point.position - a.point.position;
    const float beforeA = dot(a.plane, way);          // how far b is before a's plane
    const float beforeB = dot(b.plane, way * -1.0f);  // and a before b's
    const bool byDepth = isSame && styleAt(p).imageOutline.detector != OutlineDetector::kPlane;
    const float off = std::max(std::fabs(beforeA), std::fabs(beforeB));
    const bool areOneBeforeOther = (beforeA > 0) != (beforeB > 0);
    const float noise = std::max(a.point.rounding, b.point.rounding);
    const bool isRidge = !areOneBeforeOther && !(beforeA > 0);
    const bool touch = off <= noise || (off <= bothTolerances(p, q) && isRidge);
    if (!isSame && touch) {
      if (isOutlined(a.instance) != isOutlined(b.instance)) return isOutlined(a.instance);
      return a.instance < b.instance;
    }
    // Each is before the other's plane, but they do not meet: it is the steeper that ends.
    if (!byDepth && beforeA > 0 && beforeB > 0) return isSteeper(p, q);
    if (byDepth || std::fabs(beforeA) == std::fabs(beforeB)) {
      if (a.point.position.z == b.point.position.z) return index(p) < index(q);
      return a.point.position.z > b.point.position.z;
    }
    return std::fabs(beforeB) > std::fabs(beforeA) ? beforeB > 0 : beforeA < 0;
  }

  /// How much of q is covered by what p shows, or by what lies before that.
  float coverage(Pixel p, Pixel q) const
  {
    if (!isInside(q)) return 1;
    if (layer(q).instance == kNobody) return layer(q).depth < layer(p).depth ? 1.0f : 0.0f;
    if (layer(q).instance == layer(p).instance) {
      if (!isOutlined(layer(p).instance) || !isEdge(p, q)) return own(q);
      return ownsEdge(p, q) ? 0.0f : 1.0f;
    }
    const float lean = leanTowards(p, q);
    if (lean == -0.5f) return 1;
    // What of q shows the instance of p.
    const Layer& l = layer(q);
    if (l.covered == l.count || l.other != layer(p).instance) return 0;
    return static_cast<float>(l.covered - l.count) / static_cast<float>(scene_.samples);
  }

  static float unit(float x) { return x > 0 ? std::min(x, 1.0f) : 0.0f; }

  /// From 0, where the planes that p and q show meet between them, to 1, where they meet nowhere
  /// near or are far apart there.
  float gapBetween(Pixel p, Pixel q) const
  {
    const Layer &a = layer(p), &b = layer(q);
    const Vec3f way = b.point.position - a.point.position;
    const float beforeA = dot(a.plane, way), beforeB = dot(b.plane, way * -1.0f);
    if (beforeA > 0 && beforeB > 0) return 0;
    const float off = std::max(std::fabs(beforeA), std::fabs(beforeB));
    // Where they bulge out: from one tolerance to two.
    const float bulging = off / bothTolerances(p, q) - 1;
    if (!(beforeA > 0) && !(beforeB > 0)) return unit(bulging);
    const Vec3f eye = betweenAndEye(a, b);
    const float depthAtP = std::fabs(beforeB) * dot(a.plane, eye);
    const float depthAtQ = std::fabs(beforeA) * dot(b.plane, eye);
    const float away = std::min(depthAtP, depthAtQ) / (std::fabs(depthAtP - depthAtQ) * 2.0f);
    const float deep = off / (std::max(a.point.rounding, b.point.rounding) +
                              0.5f * std::max(a.point.pixel, b.point.pixel));
    const float gap = away < deep ? away : deep;
    const bool isNearThatBefore = beforeB > 0 ? depthAtP < depthAtQ : depthAtQ < depthAtP;
    return unit(isNearThatBefore ? std::max(gap, bulging) : gap);
  }
  /// How much more than half of the width of the line between p and q is on the side of p.
  float leanTowards(Pixel p, Pixel q) const
  {
    const bool hasLine = isOutlined(layer(p).instance) || isOutlined(layer(q).instance);
    const float gap = hasLine ? gapBetween(p, q) : 1.0f;
    const float whole = gap > 0 && ownsEdge(p, q) ? 0.5f : -0.5f;
    if (gap >= 1) return whole;
    Vec3f eye = betweenAndEye(layer(p), layer(q));
    // Squares of squares of it must not overflow.
    int exponent = 0;
    std::frexp(std::max({std::fabs(eye.x), std::fabs(eye.y), std::fabs(eye.z)}), &exponent);
    eye = eye * std::ldexp(1.0f, -exponent);
    const float more = nearnessOfOutline(p, eye) - nearnessOfOutline(q, eye);
    const float lean = more > -0.5f ? std::min(more, 0.5f) : -0.5f;
    return gap > 0 ? lean + (whole - lean) * gap : lean;
  }
  /// Neither ends before the other.
  static bool isCut(float lean) { return std::fabs(lean) < 0.5f; }
  float partBefore(Pixel q, float lean) const
  {
    return isOutlined(layer(q).instance) ? 0.5f + lean : unit((0.5f + lean) * 4);
  }
  /// 1.5 over the distance to the outline of what p shows, at least for those so steep that nobody
  /// can tell: 12 pixels in depth for one aside, and wholly at 17.
  float nearnessOfOutline(Pixel p, Vec3f eye) const
  {
    const float cosine = dot(layer(p).plane, eye);
    const float steep = 2.0f - cosine * cosine * 290.0f / dot(eye, eye);
    const float inverse = inverseDistanceOfOutline(p, eye);
    // Of what is no number the normals tell.
    return (steep > inverse ? std::min(steep, 1.0f) : inverse) * 1.5f;
  }
  /// The square of the normal's cosine is 1 - (r/R)^2 on a sphere, r from the outline's middle. The
  /// length of its gradient over it, upwards: one over how many pixels there are to the outline.
  /// By what is seen four pixels away, as normals are found anywhere in their pixels, or by two or
  /// one where it is not or is turned by more than 30 degrees, as beyond a sharp edge.
  float inverseDistanceOfOutline(Pixel p, Vec3f eye) const
  {
    const auto squared = [&](Pixel q) {
      const float cosine = dot(layer(q).normal, eye);
      return cosine * cosine;
    };
    const float here = squared(p);
    const auto rise = [&](int dx, int dy) {
      for (const int n : {4, 2, 1}) {
        const Pixel q = {p.x + n * dx, p.y + n * dy};
        if (!isInside(q) || layer(q).instance != layer(p).instance) continue;
        const bool isSharp = 1.0f - dot(layer(p).normal, layer(q).normal) > 0.134f;
        if (!isSharp) return (squared(q) - here) * (4.0f / static_cast<float>(n));
      }
      return 0.0f;
    };
    const Vec2f gradient = {std::max(0.0f, std::max(rise(-1, 0), rise(1, 0))),
                            std::max(0.0f, std::max(rise(0, -1), rise(0, 1)))};
    // Nearer than a pixel is at the outline; so is a normal perpendicular to the gaze.
    if (std::sqrt(dot2(gradient, gradient)) >= here * 4) return 1;
    return std::sqrt(dot2(gradient, gradient)) / (here * 4);
  }
  Vec2f cutPlace(Pixel p, Pixel q) const
  {
    const Vec2f a = layer(p).place, b = layer(q).place;
    const float meeting = unit(wayToMeeting(p, q));
    return a + (b - a) * (meeting + (0.5f - meeting) * gapBetween(p, q));
  }

  void findAt(Pixel p)
  {
    findEdges(p);
    if (!isOutlined(layer(p).instance)) return;
    if (const auto place = crossing(p, {p.x + 1, p.y})) right_[index(p)] = place;
    if (const auto place = crossing(p, {p.x, p.y + 1})) above_[index(p)] = place;
  }

  /// A neighbour of a pixel, as the pixel's surface has to do with it.
  struct Neighbour {
    Pixel at;
    float share;  ///< coverage()
    float part;   ///< of the line between them that is the pixel's
    bool isCut;
    float theirs;   ///< that of what is there, if that is another instance
    bool isHiding;  ///< the pixel's surface may go on behind what is there, or is not known there
  };
  Neighbour neighbour(Pixel p, Pixel q) const
  {
    const float share = coverage(p, q);
    if (!isInside(q)) return {q, share, 0, false, 0, true};
    if (layer(q).instance == kNobody)
      return {q, share, share > 0 ? 0.0f : 1.0f, false, 0, share > 0};
    if (layer(q).instance == layer(p).instance) {
      const bool isPart = isOutlined(layer(p).instance) && isEdge(p, q);
      const bool ends = isPart && ownsEdge(p, q);
      const bool isByPlanes = styleAt(p).imageOutline.detector == OutlineDetector::kPlane;
      return {q, share, ends ? 1.0f : 0.0f, false, 0, isPart && !ends && isByPlanes};
    }
    const float lean = leanTowards(p, q);
    const float theirs = partBefore(p, leanTowards(q, p));
    return {q, share, partBefore(q, lean), isCut(lean), theirs, lean == -0.5f};
  }

  void findEdges(Pixel p)
  {
    if (layer(p).instance == kNobody) return;
    if (!isOutlined(layer(p).instance) && own(p) == 1) return;
    float c[3][3];  // [row][column] about p
    c[1][1] = own(p);
    std::vector<Neighbour> around;
    for (const Pixel d : kAround) {
      around.push_back(neighbour(p, {p.x + d.x, p.y + d.y}));
      c[d.y + 1][d.x + 1] = around.back().share;
    }
    const float root2 = 1.41421356f;
    const Vec2f in = {root2 * (c[1][2] - c[1][0]) + ((c[2][2] + c[0][2]) - (c[2][0] + c[0][0])),
                      root2 * (c[2][1] - c[0][1]) + ((c[2][2] + c[2][0]) - (c[0][2] + c[0][0]))};
    const float length = std::sqrt(dot2(in, in));
    const bool isBesideHidden =
        std::any_of(around.begin(), around.end(), [](const Neighbour& q) { return q.isHiding; });
    Edge edge = {centre(p), {0, 0}, p, layer(p).instance, p, 1, isBesideHidden};
    if (length > 0) edge.normal = {-in.x / length, -in.y / length};
    if (own(p) == 1)
      findEdgesOfWhole(p, edge, around);
    else
      findEdgesOfPart(p, edge, around);
  }
  /// Borders run between the pixel and the next.
  void findEdgesOfWhole(Pixel p, const Edge& edge, const std::vector<Neighbour>& around)
  {
    const std::vector<Neighbour> beside = {around.begin(), around.begin() + 4};
    float distance = 1;
    bool isBare = false;
    for (const Neighbour& q : beside) {
      if (q.share > 0 || q.isCut) continue;
      isBare = true;
      const float half = 0.5f * (edge.normal.x * static_cast<float>(q.at.x - p.x) +
                                 edge.normal.y * static_cast<float>(q.at.y - p.y));
      if (half > 0) distance = std::min(distance, half);
    }
    if (isBare) {
      Edge found = edge;
      found.foot = edge.foot + edge.normal * distance;
      edges_[index(p)].push_back(found);
    }
    for (const Neighbour& q : beside)
      if (q.isCut && !(q.share > 0) && q.part > 0)
        edges_[index(p)].push_back(
            {cutPlace(p, q.at), edge.normal, p, edge.of, p, q.part, edge.isBesideHidden});
  }
  /// A border runs through the pixel; where surfaces cut each other it is that of both.
  void findEdgesOfPart(Pixel p, Edge edge, const std::vector<Neighbour>& around)
  {
    const bool hasWay = !(edge.normal == Vec2f{0, 0});
    if (hasWay) edge.foot = edge.foot + edge.normal * distanceOf(edge.normal, own(p));
    const Layer& l = layer(p);
    const bool isShared = l.covered > l.count && l.other != l.instance;
    std::vector<Neighbour> beyond;
    std::vector<float> parts, theirs, anys, shifts;
    for (const Neighbour& q : around) {
      if (q.part > 0) anys.push_back(q.part);
      if (!isShared || !isInside(q.at) || layer(q.at).instance != l.other) continue;
      beyond.push_back(q);
      parts.push_back(q.part);
      theirs.push_back(q.theirs);
      shifts.push_back(q.isCut ? shiftTo(p, q.at, edge) : 0.0f);
    }
    // Of the border to what the pixel's other samples show, or to anything.
    if (!parts.empty()) {
      edge.part = meanOf(parts);
      edge.foot = edge.foot + edge.normal * meanOf(shifts);
    } else if (!anys.empty()) {
      edge.part = meanOf(anys);
    }
    if (isOutlined(edge.of) && edge.part > 0) edges_[index(p)].push_back(edge);
    if (!hasWay || theirs.empty() || !isOutlined(l.other) || !(meanOf(theirs) > 0)) return;
    edges_[index(p)].push_back({edge.foot, edge.normal * -1.0f, p, l.other, beyond.front().at,
                                meanOf(theirs), edge.isBesideHidden});
  }
  /// Along the normal of an edge that samples tell to one of them, to where the planes meet that p
  /// and q show; less where these cut each other less.
  float shiftTo(Pixel p, Pixel q, const Edge& edge) const
  {
    const float one = 1.0f / static_cast<float>(scene_.samples);
    const float off = dot2(edge.normal, cutPlace(p, q) - edge.foot);
    const float bounded = off > -one ? std::min(off, one) : -one;
    return bounded * (1.0f - 2.0f * std::fabs(leanTowards(p, q)));
  }
  /// Straightens borders where they come to what hides them, or to the apron's end, which turns
  /// them: as the others within six pixels lie in the mean, the farther the more. Nothing is known
  /// of ends that have no edge of theirs within three pixels, or that would be moved by more than
  /// half a pixel.
  void straightenEnds()
  {
    for (std::vector<Edge>& edges : edges_)
      for (Edge& edge : edges)
        if (edge.isBesideHidden) straighten(edge);
  }
  void straighten(Edge& end) const
  {
    using Edges = std::vector<const Edge*>;
    const auto far = [&](const Edge* edge) {
      const Vec2f way = edge->foot - end.foot;
      return dot2(way, way);
    };
    Edges candidates, through;
    for (int y = end.at.y - 6; y <= end.at.y + 6; ++y)
      for (int x = end.at.x - 6; x <= end.at.x + 6; ++x) {
        if (!isInside({x, y})) continue;
        for (const Edge& edge : edges_[index({x, y})])
          if (!edge.isBesideHidden && edge.of == end.of && showSame(end.shown, edge.shown))
            candidates.push_back(&edge);
      }
    for (const Edge* edge : candidates) {
      const bool isThrough = std::fabs(dot2(edge->normal, edge->foot - end.foot)) <= 1;
      if (isThrough && far(edge) < 9 && dot2(edge->normal, end.normal) >= 0.4f)
        through.push_back(edge);
    }
    if (through.empty()) return;
    const Edge* const next =
        *std::min_element(through.begin(), through.end(),
                          [&](const Edge* a, const Edge* b) { return far(a) < far(b); });
    Vec2f normals = {0, 0}, ways = {0, 0};
    float sum = 0;
    for (const Edge* edge : candidates) {
      const bool isOfBorder = dot2(edge->normal, next->normal) >= 0.7f &&
                              std::fabs(dot2(next->normal, edge->foot - next->foot)) <= 1;
      if (!isOfBorder) continue;
      const float weight = std::sqrt(far(edge));
      normals = normals + edge->normal * weight;
      ways = ways + (edge->foot - end.foot) * weight;
      sum += weight;
    }
    const float length = std::sqrt(dot2(normals, normals));
    if (!(length > 0)) return;
    const Vec2f normal = normals * (1.0f / length);
    const float off = dot2(normal, ways) / sum;
    if (!(std::fabs(off) <= 0.5f)) return;
    end.normal = normal;
    // The place of a cut is that of its planes.
    if (!(end.part < 1)) end.foot = end.foot + normal * off;
  }
  static float meanOf(const std::vector<float>& values)
  {
    float sum = 0;
    for (const float value : values)
      sum += value;
    return sum / static_cast<float>(values.size());
  }

  /// Takes away edges that are seen in few pixels, none of which touches another instance's, or
  /// nobody's, or the apron's end. They part no pixels, and are creases where normals differ.
  /// Where these do not, but a crossing leaves the pixel or one that touches it, they are parts of
  /// its line and stay.
  void dropSpecks()
  {
    std::vector<bool> isSeen(edges_.size(), false);
    forEachPixel([&](Pixel start) {
      if (isSeen[index(start)] || !hasOwnEdge(start)) return;
      std::vector<Pixel> found = {start};
      isSeen[index(start)] = true;
      bool isKept = false;
      for (std::size_t i = 0; i < found.size(); ++i) {
        const Pixel p = found[i];
        const bool isBent = std::all_of(std::begin(kBeside), std::end(kBeside), [&](Pixel d) {
          const Pixel q = {p.x + d.x, p.y + d.y};
          return !isStepTo(p, q) || isCrease(p, q);
        });
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            const Pixel q = {p.x + dx, p.y + dy};
            if (!isInside(q) || layer(q).instance != layer(p).instance) {
              isKept = true;
              continue;
            }
            if (!isBent && (right_[index(q)] || above_[index(q)])) isKept = true;
            if (isSeen[index(q)] || !hasOwnEdge(q)) continue;
            isSeen[index(q)] = true;
            found.push_back(q);
          }
      }
      if (isKept || found.size() >= ImageOutline::kSmallestStep) return;
      for (const Pixel p : found) {
        edges_[index(p)].clear();
        isUnited_[index(p)] = true;
      }
    });
    forEachPixel([&](Pixel p) {
      if (!isOutlined(layer(p).instance)) return;
      const Pixel right = {p.x + 1, p.y}, above = {p.x, p.y + 1};
      if (isSpeckTo(p, right)) right_[index(p)] = crossingPlace(p, right);
      if (isSpeckTo(p, above)) above_[index(p)] = crossingPlace(p, above);
    });
  }

  bool hasOwnEdge(Pixel p) const
  {
    return std::any_of(edges_[index(p)].begin(), edges_[index(p)].end(),
                       [&](const Edge& edge) { return edge.of == layer(p).instance; });
  }

  /// A way between a pixel and that to its right, or that above.
  struct Way {
    Pixel from;
    bool isRight;
    Pixel to() const { return isRight ? Pixel{from.x + 1, from.y} : Pixel{from.x, from.y + 1}; }
  };
  const std::optional<Vec2f>& placeOn(Way way) const
  {
    return (way.isRight ? right_ : above_)[index(way.from)];
  }
  bool hasCrease(Way way) const { return isInside(way.from) && isInside(way.to()) && placeOn(way); }
  /// The ways that cross another one's squares: of each the other three sides.
  static std::vector<Way> besideOf(Way way)
  {
    std::vector<Way> beside;
    const Pixel p = way.from;
    for (const Pixel square : way.isRight ? std::vector<Pixel>{p, {p.x, p.y - 1}}
                                          : std::vector<Pixel>{p, {p.x - 1, p.y}}) {
      beside.push_back({square, true});
      beside.push_back({square, false});
      beside.push_back({{square.x + 1, square.y}, false});
      beside.push_back({{square.x, square.y + 1}, true});
    }
    return beside;
  }
  /// Whether a crease there goes on as another line, or may do so where something else is shown.
  bool endsAtLine(Pixel p) const
  {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Pixel q = {p.x + dx, p.y + dy};
        if (!isInside(q) || layer(q).instance != layer(p).instance || !edges_[index(q)].empty())
          return true;
      }
    return false;
  }
  bool hasIdBorder(Way way) const
  {
    return styleAt(way.from).imageOutline.ids && layer(way.from).id != layer(way.to()).id;
  }

  /// Takes away creases that are crossed by few ways, none of which is at another line.
  void dropShortCreases()
  {
    std::vector<bool> isSeen[2] = {std::vector<bool>(edges_.size()),
                                   std::vector<bool>(edges_.size())};
    const auto see = [&](Way way, std::vector<Way>& found) {
      if (!hasCrease(way) || isSeen[way.isRight][index(way.from)]) return;
      if (!found.empty() && layer(way.from).instance != layer(found[0].from).instance) return;
      isSeen[way.isRight][index(way.from)] = true;
      found.push_back(way);
    };
    forEachPixel([&](Pixel p) {
      for (const bool isRight : {true, false}) {
        std::vector<Way> found;
        see({p, isRight}, found);
        for (std::size_t i = 0; i < found.size(); ++i)
          for (const Way& way : besideOf(found[i]))
            see(way, found);
        const bool isKept = std::any_of(found.begin(), found.end(), [&](const Way& way) {
          return hasIdBorder(way) || endsAtLine(way.from) || endsAtLine(way.to());
        });
        if (isKept || found.size() >= ImageOutline::kShortestCrease) continue;
        for (const Way& way : found)
          (way.isRight ? right_ : above_)[index(way.from)].reset();
      }
    });
  }

  bool isStepTo(Pixel p, Pixel q) const
  {
    return isInside(q) && layer(q).instance == layer(p).instance && isEdge(p, q);
  }
  bool isSpeckTo(Pixel p, Pixel q) const
  {
    return isStepTo(p, q) && (isUnited_[index(p)] || isUnited_[index(q)]);
  }

  /// Where there is a crease or a border of ids between p and q, and no step.
  std::optional<Vec2f> crossing(Pixel p, Pixel q) const
  {
    if (!isInside(q) || layer(q).instance != layer(p).instance || isEdge(p, q)) return {};
    return crossingPlace(p, q);
  }
  std::optional<Vec2f> crossingPlace(Pixel p, Pixel q) const
  {
    if (isCrease(p, q)) return creasePlace(p, q);
    if (styleAt(p).imageOutline.ids && layer(p).id != layer(q).id) return idBorderPlace(p, q);
    return {};
  }

  bool isCrease(Pixel p, Pixel q) const
  {
    const ImageOutline& outline = styleAt(p).imageOutline;
    const float least = std::max(1.0f - static_cast<float>(cosineOfDegrees(outline.creaseDegrees)),
                                 ImageOutline::kSameNormals);
    const float turn = 1.0f - dot(layer(p).normal, layer(q).normal);
    switch (outline.creases) {
      case CreaseDetector::kSobel:
        return least < 2 && turn > least * (1.0f / 9) &&
               std::max(sobelOfNormals(p), sobelOfNormals(q)) > least / 2;
      case CreaseDetector::kLaplacian: {
        const Vec3f a = laplacianOfNormals(p), b = laplacianOfNormals(q);
        return least < 2 && dot(a, b) < 0 && dot(b - a, b - a) > 8 * least;
      }
      default:
        return turn > least;
    }
  }
  /// That at q if the instance of p is there, else at p.
  Vec3f normalAt(Pixel p, Pixel q) const
  {
    const bool isThere = isInside(q) && layer(q).instance == layer(p).instance;
    return layer(isThere ? q : p).normal;
  }
  /// How normals change per pixel, squared.
  float sobelOfNormals(Pixel p) const
  {
    const auto n = [&](int dx, int dy) { return normalAt(p, {p.x + dx, p.y + dy}); };
    Vec3f gx = {0, 0, 0}, gy = {0, 0, 0};
    for (int i = -1; i <= 1; ++i) {
      const float weight = i == 0 ? 2.0f : 1.0f;
      gx = gx + (n(1, i) - n(-1, i)) * weight;
      gy = gy + (n(i, 1) - n(i, -1)) * weight;
    }
    return (dot(gx, gx) + dot(gy, gy)) / 64.0f;
  }
  Vec3f laplacianOfNormals(Pixel p) const
  {
    const Vec3f sides = normalAt(p, {p.x + 1, p.y}) + normalAt(p, {p.x - 1, p.y});
    const Vec3f ends = normalAt(p, {p.x, p.y + 1}) + normalAt(p, {p.x, p.y - 1});
    return (sides + ends) - layer(p).normal * 4.0f;
  }

  /// How much of r shows p's id, for two ids p and q. Where the instance is not seen p's goes on
  /// before and q's behind.
  float idShare(Pixel p, Pixel q, Pixel r) const
  {
    if (!isInside(r) || layer(r).instance != layer(p).instance) {
      const int steps = (r.x - p.x) * (q.x - p.x) + (r.y - p.y) * (q.y - p.y);
      return steps > 0 ? 0.0f : 1.0f;
    }
    const float share = static_cast<float>(layer(r).idSamples) / static_cast<float>(layer(r).count);
    if (layer(r).id == layer(p).id) return share;
    return layer(r).id == layer(q).id ? 1.0f - share : 0.0f;
  }

  /// The height function of p's id over the line between p and q, or beside it, in a window of four
  /// by three pixels.
  Vec2f idBorderPlace(Pixel p, Pixel q) const
  {
    const Pixel d = {q.x - p.x, q.y - p.y}, e = {d.y, d.x};
    const auto share = [&](int i, int j) {
      return idShare(p, q, {p.x + i * d.x + j * e.x, p.y + i * d.y + j * e.y});
    };
    float along = 0, across = 0;  // how p's id grows
    for (int j = -1; j <= 1; ++j)
      along += share(1, j) + share(2, j) - (share(-1, j) + share(0, j));
    for (int i = -1; i <= 2; ++i)
      across += share(i, 1) - share(i, -1);
    const bool isAlong = std::fabs(along) >= std::fabs(across);
    const bool isBehind = (isAlong ? along : across) > 0;
    const auto lower = [&](int i, int j) { return isBehind ? 1 - share(i, j) : share(i, j); };
    // The ends of a stack show the lower id below and the other above, or they show a third.
    const auto bottom = [&](int i, int j) { return lower(i, j) < 0.5f ? 1 : lower(i, j); };
    const auto top = [&](int i, int j) { return lower(i, j) > 0.5f ? 0 : lower(i, j); };
    Vec2f offset = {0.5f, 0};
    if (isAlong) {
      // At 45 degrees or more it does not leave these two, as p shows more of its id and q of its.
      offset.x = lower(0, 0) + lower(1, 0) - 0.5f;
    } else {
      const float first = bottom(0, -1) + lower(0, 0) + top(0, 1);
      const float second = bottom(1, -1) + lower(1, 0) + top(1, 1);
      offset.y = std::clamp((first + second) / 2 - 1.5f, -1.0f, 1.0f);
    }
    return centre(p) + Vec2f{d.x == 1 ? offset.x : offset.y, d.x == 1 ? offset.y : offset.x};
  }

  /// Where the planes that p and q show meet, as a part of the way between the two.
  float wayToMeeting(Pixel p, Pixel q) const
  {
    const Layer &a = layer(p), &b = layer(q);
    const Vec3f eye = betweenAndEye(a, b);
    const Vec3f way = b.point.position - a.point.position;
    const float gapAtP = dot(b.plane, way * -1.0f) / dot(b.plane, eye);
    const float gapAtQ = -(dot(a.plane, way) / dot(a.plane, eye));
    return gapAtP / (gapAtP - gapAtQ);
  }
  Vec2f creasePlace(Pixel p, Pixel q) const
  {
    float t = wayToMeeting(p, q);
    if (!(t > 0 && t < 1)) t = 0.5f;
    return layer(p).place + (layer(q).place - layer(p).place) * t;
  }

  /// Of the square between the centres of p, the pixels to its right and above, and the fourth.
  void joinAt(Pixel p)
  {
    const Pixel east = {p.x + 1, p.y}, north = {p.x, p.y + 1};
    std::vector<Way> sides = {{p, true}, {p, false}};
    if (isInside(east)) sides.push_back({east, false});
    sides.push_back({north, true});
    sides.erase(std::remove_if(sides.begin(), sides.end(), [&](Way way) { return !placeOn(way); }),
                sides.end());
    // Those of the same instance, and then the others.
    while (!sides.empty()) {
      const auto isOther = [&, first = sides[0]](Way way) {
        return layer(way.from).instance != layer(first.from).instance;
      };
      const auto others =
          std::stable_partition(sides.begin(), sides.end(), [&](Way way) { return !isOther(way); });
      joinWays(p, {sides.begin(), others}, segments_[index(p)]);
      sides.erase(sides.begin(), others);
    }
  }
  /// Coefficients of x, y and depth in the equation of what p shows, in pixels.
  Vec3f planeInWindow(Pixel p) const
  {
    const Vec3f plane = layer(p).plane;
    const float constant = dot(plane, layer(p).point.position);
    const Mat4f& view = toView_.matrix();
    float of[3];
    for (int k = 0; k < 3; ++k)
      of[k] = plane.x * view.m[0][k] + plane.y * view.m[1][k] + plane.z * view.m[2][k] -
              constant * view.m[3][k];
    return {of[0], of[1], of[2]};
  }
  /// How far the crease between p and q goes on into the square at their side, if there something
  /// lies before it.
  Vec2f wayBehind(Pixel p, Pixel q, Pixel side) const
  {
    const auto isHidden = [&](Pixel from) {
      const Pixel to = {from.x + side.x, from.y + side.y};
      if (!isInside(to) || layer(to).instance == kNobody) return false;
      return layer(to).instance != layer(from).instance && neighbour(from, to).isHiding;
    };
    const bool isId = styleAt(p).imageOutline.ids && layer(p).id != layer(q).id;
    if (!isCrease(p, q) || isId || !(isHidden(p) || isHidden(q))) return {0, 0};
    if (1 - dot(layer(p).plane, layer(q).plane) <= ImageOutline::kSameNormals) return {0, 0};
    const Vec3f of = planeInWindow(p), other = planeInWindow(q);
    Vec2f way = {of.y * other.z - of.z * other.y, of.z * other.x - of.x * other.z};
    const float length = std::sqrt(dot2(way, way));
    if (!std::isfinite(length) || length == 0) return {0, 0};
    if (way.x * static_cast<float>(side.x) + way.y * static_cast<float>(side.y) < 0)
      way = way * -1.0f;
    return way * ((styleAt(p).outlineWidth / 2 + 2) / length);
  }
  void joinWays(Pixel square, const std::vector<Way>& ways, std::vector<Segment>& segments) const
  {
    const Pixel owner = ways[0].from, beyond = ways[0].to();
    if (ways.size() == 1) {
      const Vec2f place = *placeOn(ways[0]);
      // The square that the crease comes to is above or to the right of its lower left pixel's
      // ways.
      const bool isFirst = owner.x == square.x && owner.y == square.y;
      const int ahead = isFirst ? 1 : -1;
      const Pixel into = ways[0].isRight ? Pixel{0, ahead} : Pixel{ahead, 0};
      segments.push_back({place, place + wayBehind(owner, beyond, into), owner, beyond});
      return;
    }
    if (ways.size() == 2) {
      segments.push_back({*placeOn(ways.front()), *placeOn(ways.back()), owner, beyond});
      return;
    }
    Vec2f middle = {0, 0};
    for (const Way way : ways)
      middle = middle + *placeOn(way);
    middle = middle * (1.0f / static_cast<float>(ways.size()));
    for (const Way way : ways)
      segments.push_back({middle, *placeOn(way), owner, beyond});
  }

  /// What lines are measured for: a share of a pixel, and a pixel that shows the surface there.
  struct Target {
    Pixel pixel, shown;
    float own;
  };

  /// Calls visit(q) for the pixels that may have edges whose line meets the target.
  template <class Visit>
  void around(const Target& target, Visit visit) const
  {
    const int reach = static_cast<int>(std::ceil(widthAt(target))) + 2;
    const Pixel p = target.pixel;
    for (int y = p.y - reach; y <= p.y + reach; ++y)
      for (int x = p.x - reach; x <= p.x + reach; ++x)
        if (isInside({x, y})) visit(Pixel{x, y});
  }
  float widthAt(const Target& target) const { return styleAt(target.shown).outlineWidth; }
  /// Between p and a pixel beside, above or below it.
  bool areSideBySide(Pixel p, Pixel q) const
  {
    if (layer(p).instance != layer(q).instance) return false;
    return isUnited_[index(p)] || isUnited_[index(q)] || !arePartedByPlanes(p, q);
  }
  /// Whether the straight way from p to q crosses no step, nor another instance. Where it goes over
  /// a corner it may go round that on either side.
  bool showSame(Pixel p, Pixel q) const
  {
    if (layer(p).instance != layer(q).instance) return false;
    const int dx = q.x - p.x, dy = q.y - p.y, n = std::max(std::abs(dx), std::abs(dy));
    const auto rounded = [&](int i, int d) {
      const int halves = (2 * i * std::abs(d) + n) / (2 * n);
      return d < 0 ? -halves : halves;
    };
    Pixel from = p;
    for (int i = 1; i <= n; ++i) {
      const Pixel to = {p.x + rounded(i, dx), p.y + rounded(i, dy)};
      const auto isFreeBy = [&](Pixel corner) {
        return areSideBySide(from, corner) && areSideBySide(corner, to);
      };
      const bool isFree = from.x != to.x && from.y != to.y
                              ? isFreeBy({to.x, from.y}) || isFreeBy({from.x, to.y})
                              : areSideBySide(from, to);
      if (!isFree) return false;
      from = to;
    }
    return true;
  }

  float shareOfLayer(Pixel p) const
  {
    if (!isOutlined(layer(p).instance)) return 0;
    return shareOfLines({p, p, own(p)}) * (1.0f - layer(p).halo);
  }

  /// Of the samples that show other surfaces than the pixel's layer: as much as if that filled the
  /// pixel which a pixel around shows, the farthest of those that lie behind the layer's end, or
  /// that cut it.
  float shareOfRest(Pixel p) const
  {
    const Layer& l = layer(p);
    if (l.instance == kNobody || l.covered == l.count || !isOutlined(l.other)) return 0;
    const auto depth = [&](Pixel q) { return layer(q).depth; };
    std::vector<Pixel> behind;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Pixel q = {p.x + dx, p.y + dy};
        if (!isInside(q) || layer(q).instance != l.other || showSame(p, q)) continue;
        if (l.other != l.instance || ownsEdge(p, q)) behind.push_back(q);
      }
    // In specks it is the same surface.
    if (l.other == l.instance && isUnited_[index(p)]) behind = {p};
    if (behind.empty()) return 0;
    const Pixel shown = *std::max_element(behind.begin(), behind.end(),
                                          [&](Pixel u, Pixel v) { return depth(u) < depth(v); });
    const float part = static_cast<float>(l.covered - l.count) / static_cast<float>(scene_.samples);
    const float behindHalo = 1.0f - layer(shown).halo;
    // Where it does not go on behind the layer it ends in the pixel.
    if (l.other != l.instance && leanTowards(p, shown) < 0.5f)
      return shareOfLines({p, shown, part}) * behindHalo;
    return shareOfLines({p, shown, 1}) * part * behindHalo;
  }

  float shareOfLines(const Target& target) const
  {
    return std::max(shareOfBorder(target), shareOfCrease(target) * target.own);
  }

  float shareOfBorder(const Target& target) const
  {
    const Pixel p = target.pixel;
    const bool isByPlanes = styleAt(target.shown).imageOutline.detector == OutlineDetector::kPlane;
    using Edges = std::vector<const Edge*>;
    Edges found, joined;
    around(target, [&](Pixel q) {
      for (const Edge& edge : edges_[index(q)]) {
        if (edge.of != layer(target.shown).instance) continue;
        // Farther out, and if no border cuts the pixel a little, it is behind a step.
        if (dot2(edge.normal, edge.foot - centre(p)) <
            (target.own < 1 || !isByPlanes ? -0.75f : -0.25f))
          continue;
        found.push_back(&edge);
        if (showSame(target.shown, edge.shown)) joined.push_back(&edge);
      }
    });
    if (joined.empty()) return 0;
    const auto way = [&](const Edge* edge) { return edge->foot - centre(p); };
    // By how far the line is, which is not the same as how far its border is if some are cuts'.
    const bool areEven =
        std::all_of(found.begin(), found.end(), [](const Edge* edge) { return edge->part >= 1; });
    const auto outside = [&](const Edge* edge) {
      const float squared = dot2(way(edge), way(edge));
      return areEven ? squared : std::sqrt(squared) - widthAt(target) * edge->part;
    };
    const auto nearestOf = [&](const Edges& edges) {
      return *std::min_element(edges.begin(), edges.end(), [&](const Edge* a, const Edge* b) {
        return outside(a) < outside(b);
      });
    };
    const Edge* const nearest = nearestOf(joined);
    // If it is the nearest of all, those beside it are of the same border.
    const Edges& same = nearestOf(found) == nearest ? found : joined;
    const Vec2f n = nearest->normal, to = way(nearest);
    if (n.x == 0 && n.y == 0) return index(nearest->at) == index(p) ? target.own : 0.0f;
    const auto along = [&](Vec2f v) { return std::fabs(n.x * v.y - n.y * v.x); };
    float distance = std::sqrt(dot2(to, to)), part = nearest->part;
    Vec2f across = n;
    if (along(to) > 1.5f) {
      // It may end there, where no other pixel's border goes on: in half a disc.
      const Vec2f t = {-n.y, n.x};
      const float side = dot2(t, to) > 0 ? -1.0f : 1.0f;
      const bool goesOn = std::any_of(same.begin(), same.end(), [&](const Edge* edge) {
        const Vec2f apart = edge->foot - nearest->foot;
        const Vec2f other = edge->normal;
        if (dot2(other, way(edge)) <= 0) return false;
        const bool isFurther = side * dot2(t, apart) > 0.5f, turns = dot2(other, n) < 0.7f;
        if (dot2(apart, apart) <= 9) return isFurther || turns;
        return isFurther && !turns && std::fabs(dot2(n, apart)) <= 1;
      });
      if (!goesOn && isByPlanes) {
        const auto shows = [&](Vec2f place) {
          const Pixel q = {static_cast<int>(std::floor(place.x)),
                           static_cast<int>(std::floor(place.y))};
          return isInside(q) && showSame(target.shown, q);
        };
        // Where the surface is seen neither beyond the end nor where the border would pass the
        // target, or of whole lines just beyond that, it goes on behind what hides it.
        const float straight = dot2(n, to);
        const float passed = nearest->part < 1 ? straight : straight + 0.5f;
        if (!shows(nearest->foot + (t * side * 1.5f + n * 0.5f)) && !shows(centre(p) + n * passed))
          return std::max(0.0f,
                          target.own - areaBelow(n, straight - widthAt(target) * nearest->part));
        const float radius = widthAt(target) * nearest->part * 0.5f;
        const Vec2f toEnd = to - n * radius;
        const float far = std::sqrt(dot2(toEnd, toEnd));
        return std::min(target.own, areaBelow(far > 0 ? toEnd * (1.0f / far) : n, radius - far));
      }
      across = to * (1.0f / distance);
    } else {
      float sum = 0, parts = 0, weights = 0;
      for (const Edge* edge : same) {
        const Vec2f other = edge->normal;
        const float weight = 3.0f - along(way(edge));
        if (weight <= 0 || dot2(other, n) < 0.7f) continue;
        // Another border beside it is none of it.
        if (std::fabs(dot2(n, edge->foot - nearest->foot)) > 1) continue;
        sum += weight * (0.5f * (dot2(other, way(edge)) + dot2(n, way(edge))));
        parts += weight * edge->part;
        weights += weight;
      }
      distance = sum / weights;
      part = parts / weights;
    }
    return std::max(0.0f, target.own - areaBelow(across, distance - widthAt(target) * part));
  }

  float shareOfCrease(const Target& target) const
  {
    const Pixel p = target.pixel;
    std::optional<Vec2f> nearest;
    Vec2f side = {0, 0};
    around(target, [&](Pixel q) {
      for (const Segment& segment : segments_[index(q)]) {
        if (!showSame(target.shown, segment.owner) && !showSame(target.shown, segment.beyond))
          continue;
        const Vec2f ab = segment.b - segment.a, a = segment.a - centre(p);
        const float length = dot2(ab, ab);
        const float t = length > 0 ? -(dot2(a, ab) / length) : 0.0f;
        const float along = std::clamp(t, 0.0f, 1.0f);
        const Vec2f to = a + ab * along;
        if (nearest && dot2(to, to) >= dot2(*nearest, *nearest)) continue;
        nearest = to;
        side = ab;
      }
    });
    if (!nearest) return 0;
    const float distance = std::sqrt(dot2(*nearest, *nearest)),
                length = std::sqrt(dot2(side, side));
    Vec2f n = {1, 0};
    if (distance > 0)
      n = *nearest * (1.0f / distance);
    else if (length > 0)
      n = {side.y / length, -side.x / length};
    const float half = widthAt(target) * 0.5f;
    return areaBelow(n, half - distance) - areaBelow(n, -half - distance);
  }

  void paintLayer(Pixel p, float share) const
  {
    if (share > 0) paint(p, share, styleAt(p), layer(p).color, layer(p).radiance);
  }
  void paintRest(Pixel p, float share) const
  {
    if (!(share > 0)) return;
    const Layer& l = layer(p);
    const std::ptrdiff_t at = p.y * frame_.rowStride + p.x;
    const Rgba8 c = frame_.color[at];
    const auto rest = [&](std::uint8_t pixel, std::uint8_t of) {
      return meanOfRest(pixel, of, l, scene_.resolve);
    };
    const Rgba8 color = {rest(c.r, l.color.r), rest(c.g, l.color.g), rest(c.b, l.color.b), 255};
    Vec3f radiance = {0, 0, 0};
    if (!frame_.radiance.empty())
      radiance = {meanOfRest(frame_.radiance.r[at], l.radiance.x, l),
                  meanOfRest(frame_.radiance.g[at], l.radiance.y, l),
                  meanOfRest(frame_.radiance.b[at], l.radiance.z, l)};
    paint(p, share, scene_.instances[l.other].style, color, radiance);
  }

  /// As if `share` of the pixel's samples, which have the colour `from`, had the line's.
  void paint(Pixel p, float share, const Style& style, Rgba8 from, Vec3f fromRadiance) const
  {
    const Layer& l = layer(p);
    const std::ptrdiff_t at = p.y * frame_.rowStride + p.x;
    Rgba8& c = frame_.color[at];
    const auto mix = [&](std::uint8_t old, std::uint8_t own, float line) {
      const float f = own;
      const std::uint8_t to = roundedByte(f + (line * 255.0f - f) * style.outlineOpacity);
      return paintByte(old, own, to, double{share} * scene_.samples, l.shared);
    };
    c.r = mix(c.r, from.r, style.outlineColor.x);
    c.g = mix(c.g, from.g, style.outlineColor.y);
    c.b = mix(c.b, from.b, style.outlineColor.z);
    if (frame_.radiance.empty()) return;
    const float part = share * static_cast<float>(scene_.samples) * style.outlineOpacity /
                       static_cast<float>(l.shared);
    const auto add = [&](float& value, float line, float own) {
      value = std::clamp(value + (line - own) * part, 0.0f, kMaxRadiance);
    };
    add(frame_.radiance.r[at], style.outlineColor.x, fromRadiance.x);
    add(frame_.radiance.g[at], style.outlineColor.y, fromRadiance.y);
    add(frame_.radiance.b[at], style.outlineColor.z, fromRadiance.z);
  }

  /// `old` is the mean of `shared` samples.
  std::uint8_t paintByte(std::uint8_t old, std::uint8_t from, std::uint8_t to, double samples,
                         int shared) const
  {
    if (scene_.resolve == Resolve::kLinear)
      return roundedByte(static_cast<float>(old + samples * (to - from) / shared));
    const ResolveTable& table = ResolveTable::gamma22();
    const auto linear = [&](std::uint8_t byte) { return static_cast<double>(table.linear(byte)); };
    const double change = std::nearbyint(samples * (linear(to) - linear(from)));
    const double sum = std::clamp(linear(old) * shared + change, 0.0, linear(255) * shared);
    return table.byteOfMean(static_cast<std::uint32_t>(sum), static_cast<std::uint32_t>(shared));
  }

  const Scene& scene_;
  const FrameView& frame_;
  const std::vector<Layer>& layers_;
  int apron_;
  ScreenToView toView_;
  std::vector<std::vector<Edge>> edges_;  ///< by the pixel that they run through or beside
  std::vector<std::optional<Vec2f>> right_, above_;  ///< creases towards these neighbours
  std::vector<bool> isUnited_;                       ///< had an edge that was a speck's
  std::vector<std::vector<Segment>> segments_;       ///< by the lower left pixel of its square
};

}  // namespace

bool isStep(const Layer& p, const Layer& q, float tolerance)
{
  const Vec3f way = q.point.position - p.point.position;
  const float beforeP = dot(p.plane, way), beforeQ = dot(q.plane, way * -1.0f);
  return std::max(std::fabs(beforeP), std::fabs(beforeQ)) > tolerance &&
         std::max(beforeP, beforeQ) > 0;
}

bool areOneSurface(const Layer& p, const Layer& q, float tolerance)
{
  const Vec3f way = q.point.position - p.point.position;
  const float beforeP = dot(p.plane, way), beforeQ = dot(q.plane, way * -1.0f);
  const bool meet = std::min(beforeP, beforeQ) > 0;
  return !isStep(p, q, tolerance) ||
         (meet && std::max(beforeP, beforeQ) <= ImageOutline::kGroove * tolerance);
}

float toleranceAt(const Scene& scene, const Layer& p)
{
  const float pixels = scene.instances[p.instance].style.imageOutline.depthTolerance;
  return pixels * p.point.pixel + p.point.rounding;
}

std::uint8_t meanOfRest(std::uint8_t pixel, std::uint8_t own, const Layer& l, Resolve resolve)
{
  const int rest = l.shared - l.count;
  if (resolve == Resolve::kLinear)
    return roundedByte(static_cast<float>(pixel * l.shared - own * l.count) /
                       static_cast<float>(rest));
  const ResolveTable& table = ResolveTable::gamma22();
  const double all = static_cast<double>(table.linear(pixel)) * l.shared;
  const double sum = std::clamp(all - static_cast<double>(table.linear(own)) * l.count, 0.0,
                                static_cast<double>(table.linear(255)) * rest);
  return table.byteOfMean(static_cast<std::uint32_t>(sum), static_cast<std::uint32_t>(rest));
}

float meanOfRest(float pixel, float own, const Layer& l)
{
  const float sum = pixel * static_cast<float>(l.shared) - own * static_cast<float>(l.count);
  return std::max(0.0f, sum) / static_cast<float>(l.shared - l.count);
}

int outlineApron(const Scene& scene)
{
  float widest = 0;
  for (const Instance& instance : scene.instances)
    if (instance.style.imageOutline.detector != OutlineDetector::kNone && !instance.isTranslucent())
      widest = std::max(widest, instance.style.outlineWidth);
  return widest > 0 ? static_cast<int>(std::ceil(widest)) + ImageOutline::kApron : 0;
}

void drawOutlines(const Scene& scene, const FrameView& frame, const std::vector<Layer>& layers,
                  int apron)
{
  Outlines(scene, frame, layers, apron).draw();
}

}  // namespace limn::reference
