// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/ReadMesh.h"

#include "Rendering/Mesh/Io/AssembleMesh.h"
#include "Rendering/Mesh/Io/NormalForm.h"
#include "Rendering/Mesh/Io/ParseNormalForm.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <new>
#include <stdexcept>

namespace limn {
namespace {

using Normalize = meshio::NormalForm (*)(meshio::Source&);

/// The check for the format of this file name; null if there is none.
Normalize normalizerOf(const std::string& path)
{
  static const std::map<std::string, Normalize> normalizers = {{".obj", meshio::normalizeObj},
                                                               {".off", meshio::normalizeOff},
                                                               {".ply", meshio::normalizePly},
                                                               {".stl", meshio::normalizeStl},
                                                               {".om", meshio::normalizeOm}};
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  const auto found = normalizers.find(extension);
  return found == normalizers.end() ? nullptr : found->second;
}

MeshFile readFile(const std::string& path, const std::function<bool(double)>& progress)
{
  meshio::Source source(path, progress);
  const Normalize normalize = normalizerOf(path);
  if (normalize == nullptr) {
    source.fail("unknown mesh format; the name must end in .obj, .off, .ply, .stl or .om");
  }
  meshio::NormalForm form = normalize(source);
  source.takeBytes();
  meshio::RawMesh raw = meshio::parseNormalForm(source, form);
  form.bytes = std::string();
  MeshFile mesh = meshio::assembleMesh(source, std::move(form), std::move(raw));
  source.reportParsed(1, 1);
  return mesh;
}

Status noMemoryFor(const std::string& path)
{
  return {Error::kFile, path + ": the mesh is too large for the memory; split it"};
}

}  // namespace

Status readMesh(const std::string& path, MeshFile& out,
                const std::function<bool(double fraction)>& progress)
{
  out = MeshFile();
  try {
    out = readFile(path, progress);
  } catch (const meshio::Fault& fault) {
    return fault.status;
  } catch (const std::bad_alloc&) {
    return noMemoryFor(path);
  } catch (const std::length_error&) {
    return noMemoryFor(path);
  }
  return {};
}

bool isMeshFileName(const std::string& path)
{
  return normalizerOf(path) != nullptr;
}

}  // namespace limn
