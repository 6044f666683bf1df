// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/ChainEdges.h"

#include "Rendering/Lines/Facing.h"

#include <algorithm>

namespace limn {
namespace {

/// Links about each point, sorted by point.
class LinksOfPoints {
 public:
  LinksOfPoints(Span<const LineLink> links, std::size_t pointCount) : first_(pointCount + 1, 0)
  {
    for (const LineLink& link : links) {
      ++first_[link.a + 1];
      ++first_[link.b + 1];
    }
    for (std::size_t p = 0; p < pointCount; ++p)
      first_[p + 1] += first_[p];
    link_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < links.size(); ++i) {
      link_[next[links[i].a]++] = static_cast<std::uint32_t>(i);
      link_[next[links[i].b]++] = static_cast<std::uint32_t>(i);
    }
  }
  Span<const std::uint32_t> at(std::uint32_t point) const
  {
    return {link_.data() + first_[point], first_[point + 1] - first_[point]};
  }

 private:
  std::vector<std::uint32_t> first_, link_;
};

class Chainer {
 public:
  Chainer(Span<const LineLink> links, std::size_t pointCount, LineChains& chains,
          std::vector<std::uint32_t>* source)
      : links_(links),
        about_(links, pointCount),
        isTaken_(links.size(), 0),
        chains_(chains),
        source_(source)
  {
    chains_ = {};
    chains_.first.push_back(0);
    if (source_ != nullptr) source_->clear();
  }

  void chain()
  {
    // Those with ends first; what is left then is loops.
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (isTaken_[i]) continue;
      if (about_.at(links_[i].a).size() != 2)
        follow(i, links_[i].a);
      else if (about_.at(links_[i].b).size() != 2)
        follow(i, links_[i].b);
    }
    for (std::size_t i = 0; i < links_.size(); ++i)
      if (!isTaken_[i]) follow(i, links_[i].a);
  }

 private:
  void follow(std::size_t link, std::uint32_t point)
  {
    for (;;) {
      isTaken_[link] = 1;
      add(point, links_[link].source);
      point = links_[link].a == point ? links_[link].b : links_[link].a;
      const Span<const std::uint32_t> about = about_.at(point);
      if (about.size() != 2) break;
      const std::uint32_t next = about[0] == link ? about[1] : about[0];
      if (isTaken_[next]) break;
      link = next;
    }
    add(point, kNoCorner);
    chains_.first.push_back(static_cast<std::uint32_t>(chains_.vertex.size()));
  }
  void add(std::uint32_t point, std::uint32_t source)
  {
    chains_.vertex.push_back(point);
    if (source_ != nullptr) source_->push_back(source);
  }

  Span<const LineLink> links_;
  LinksOfPoints about_;
  std::vector<char> isTaken_;
  LineChains& chains_;
  std::vector<std::uint32_t>* source_;
};

}  // namespace

void chainLinks(Span<const LineLink> links, std::size_t pointCount, LineChains& chains,
                std::vector<std::uint32_t>* source)
{
  Chainer(links, pointCount, chains, source).chain();
}

EdgeChains chainEdges(const EdgeTable& table, Span<const std::uint32_t> edges)
{
  // By numbers of their own, as there are few of them: a table of all places would take longer.
  std::vector<std::uint32_t> places;
  places.reserve(2 * edges.size());
  for (const std::uint32_t e : edges)
    for (const std::uint32_t place : table.edges[e].vertex)
      places.push_back(place);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const auto numberOf = [&](std::uint32_t place) {
    const auto at = std::lower_bound(places.begin(), places.end(), place);
    return static_cast<std::uint32_t>(at - places.begin());
  };
  std::vector<LineLink> links;
  links.reserve(edges.size());
  for (const std::uint32_t e : edges)
    links.push_back({numberOf(table.edges[e].vertex[0]), numberOf(table.edges[e].vertex[1]), e});
  EdgeChains result;
  chainLinks(links, places.size(), result.chains, &result.edge);
  for (std::uint32_t& vertex : result.chains.vertex)
    vertex = places[vertex];
  return result;
}

EdgeChains chainEdges(const EdgeTable& table, Span<const std::uint8_t> kindsOfEdges, unsigned kinds)
{
  std::vector<std::uint32_t> edges;
  for (std::size_t e = 0; e < table.edges.size(); ++e)
    if ((kindsOfEdges[e] & kinds) != 0) edges.push_back(static_cast<std::uint32_t>(e));
  return chainEdges(table, edges);
}

void markOuterEdges(const MeshView& mesh, const EdgeTable& table, const Camera& camera,
                    const Mat4d& modelToWorld, EdgeChains& chains)
{
  const Facing facing(mesh, camera, modelToWorld);
  chains.chains.flags.assign(chains.edge.size(), 0);
  for (std::size_t i = 0; i < chains.edge.size(); ++i)
    if (chains.edge[i] != kNoCorner && facing.isOuter(table, table.edges[chains.edge[i]]))
      chains.chains.flags[i] = kOuterLine;
}

}  // namespace limn
