// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/Io/ReadMesh.h"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace limn {

/// A folder that lives as long as this object.
class TemporaryFolder {
 public:
  TemporaryFolder()
  {
    static std::atomic<int> count{0};
    path_ = std::filesystem::temp_directory_path() /
            ("limn-test-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& content) const
  {
    std::ofstream(file(name), std::ios::binary) << content;
    return file(name);
  }

 private:
  std::filesystem::path path_;
};

struct ReadResult {
  Status status;
  MeshFile mesh;
};

/// Writes `content` to a file called `name` and reads that.
inline ReadResult readContent(const std::string& name, const std::string& content)
{
  const TemporaryFolder folder;
  ReadResult result;
  result.status = readMesh(folder.write(name, content), result.mesh);
  return result;
}

using Polygons = std::vector<std::vector<std::uint32_t>>;

inline Polygons polygonsOf(const MeshFile& mesh)
{
  Polygons polygons;
  for (std::size_t i = 0; i < mesh.polygonCount(); ++i) {
    const auto corner = [&mesh](std::uint64_t c) {
      return mesh.polygonCorners.begin() + static_cast<std::ptrdiff_t>(c);
    };
    polygons.emplace_back(corner(mesh.polygonOffsets[i]), corner(mesh.polygonOffsets[i + 1]));
  }
  return polygons;
}

inline std::vector<int> channels(const std::vector<Rgba8>& colors)
{
  std::vector<int> values;
  for (const Rgba8& c : colors)
    values.insert(values.end(), {c.r, c.g, c.b, c.a});
  return values;
}

}  // namespace limn
