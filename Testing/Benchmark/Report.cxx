// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include <cstdio>

namespace
{
constexpr double kPerMillion = 1e-6, kPerThousand = 1e-3;

nlohmann::json ToJson(const Limit& limit, const Floor& floor)
{
  const auto perThread = [&](double milliseconds) { return milliseconds / limit.Threads; };
  return { { "ms", limit.Milliseconds(floor) }, { "memory ms", limit.MemoryMilliseconds(floor) },
    { "processor ms", limit.ProcessorMilliseconds(floor) }, { "clusters", floor.Clusters },
    { "triangles", floor.Triangles }, { "geometry bytes", floor.GeometryBytes },
    { "read GB/s", floor.ReadBytesPerMillisecond * kPerMillion },
    { "sift ms", perThread(floor.Sift) }, { "cover ms", perThread(floor.Cover) } };
}
}

nlohmann::json ToJson(const Scene& scene, const SceneResult& result)
{
  const double millions = scene.CountTriangles() * kPerMillion;
  const double peer = result.Ways.back().MedianMilliseconds;
  nlohmann::json figures = { { "scene", scene.Name }, { "triangles", scene.CountTriangles() },
    { "actors", scene.Parts.size() }, { "width", scene.Width }, { "height", scene.Height },
    { "samples", scene.Samples } };
  for (const WayResult& way : result.Ways)
  {
    figures["ways"].push_back({ { "way", way.Name }, { "median ms", way.MedianMilliseconds },
      { "first ms", way.FirstMilliseconds },
      { "Mtri/s", millions / (way.MedianMilliseconds * kPerThousand) },
      { "ratio", peer / way.MedianMilliseconds },
      { "bytes per triangle", way.Memory.Kept / scene.CountTriangles() },
      { "peak MB", way.Memory.Peak * kPerMillion }, { "differing pixels", way.DifferingPixels } });
  }
  if (!result.HasLimit)
  {
    return figures;
  }
  const Limit& limit = result.Bound;
  const auto perThread = [&](double milliseconds) { return milliseconds / limit.Threads; };
  figures["limit"] = { { "threads", limit.Threads }, { "attribute bytes", limit.AttributeBytes },
    { "picture bytes", limit.PictureBytes },
    { "write GB/s", limit.WriteBytesPerMillisecond * kPerMillion },
    { "bound ms", perThread(limit.Bound) }, { "shade ms", perThread(limit.Shade) },
    { "resolve ms", perThread(limit.Resolve) }, { "fragments", limit.Fragments },
    { "tiles", limit.Tiles }, { "largest tile ms", limit.LargestTile },
    { "full", ToJson(limit, limit.Full) }, { "oracle", ToJson(limit, limit.Oracle) },
    { "differing pixels", result.ReplayDifferingPixels } };
  figures["limit"]["full"]["fraction"] = result.OfFullLimit;
  figures["limit"]["oracle"]["fraction"] = result.OfOracleLimit;
  return figures;
}

void Print(const nlohmann::json& figures)
{
  std::printf("\n%s: %lld triangles, %d x %d\n", figures["scene"].get<std::string>().c_str(),
    figures["triangles"].get<long long>(), figures["width"].get<int>(),
    figures["height"].get<int>());
  std::printf("  %-12s %9s %9s %9s %9s %9s %9s %9s\n", "", "ms", "first ms", "Mtri/s", "ratio",
    "B/tri", "peak MB", "differ");
  for (const nlohmann::json& way : figures["ways"])
  {
    std::printf("  %-12s %9.1f %9.0f %9.1f %8.1fx %9.0f %9.0f %9lld\n",
      way["way"].get<std::string>().c_str(), way["median ms"].get<double>(),
      way["first ms"].get<double>(), way["Mtri/s"].get<double>(), way["ratio"].get<double>(),
      way["bytes per triangle"].get<double>(), way["peak MB"].get<double>(),
      way["differing pixels"].get<long long>());
  }
  if (!figures.contains("limit"))
  {
    std::fflush(stdout);
    return;
  }
  const nlohmann::json& limit = figures["limit"];
  for (const char* set : { "full", "oracle" })
  {
    const nlohmann::json& floor = limit[set];
    std::printf("  limit %-6s %9.1f   limn is at %.0f %% of it; memory %.1f, processor %.1f: "
                "bound %.2f, sift %.2f, cover %.2f, shade %.2f, resolve %.2f\n",
      set, floor["ms"].get<double>(), 100 * floor["fraction"].get<double>(),
      floor["memory ms"].get<double>(), floor["processor ms"].get<double>(),
      limit["bound ms"].get<double>(), floor["sift ms"].get<double>(),
      floor["cover ms"].get<double>(), limit["shade ms"].get<double>(),
      limit["resolve ms"].get<double>());
  }
  if (limit["differing pixels"] != 0)
  {
    std::printf("  The limit's picture differs in %lld pixels.\n",
      limit["differing pixels"].get<long long>());
  }
  std::fflush(stdout);
}
