// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes the meshes of Data/Meshes into the folder named on the command line.
#include "Data/Generator/GeneratedMeshes.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <locale>
#include <string>

namespace {

using limn::GeneratedMesh;
using limn::Vec3f;

/// A file in the making: text with nine digits, bytes in the order of little-endian machines.
class MeshFile {
 public:
  explicit MeshFile(const std::string& path) : path_(path), stream_(path, std::ios::binary)
  {
    stream_.imbue(std::locale::classic());
    stream_.precision(9);
  }
  ~MeshFile()
  {
    stream_.close();
    if (!stream_) std::cerr << "cannot write " << path_ << "\n";
  }
  MeshFile(const MeshFile&) = delete;
  MeshFile& operator=(const MeshFile&) = delete;

  template <class T>
  MeshFile& operator<<(const T& value)
  {
    stream_ << value;
    return *this;
  }
  MeshFile& operator<<(Vec3f v)
  {
    stream_ << v.x << ' ' << v.y << ' ' << v.z;
    return *this;
  }
  template <class T>
  void bytes(T value)
  {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof raw);
    stream_.write(raw, sizeof raw);
  }
  void bytes(Vec3f v)
  {
    bytes(v.x);
    bytes(v.y);
    bytes(v.z);
  }

 private:
  std::string path_;
  std::ofstream stream_;
};

void writeObj(const GeneratedMesh& mesh, const std::string& path)
{
  MeshFile file(path);
  for (const Vec3f p : mesh.positions)
    file << "v " << p << '\n';
  for (const limn::Vec2f t : mesh.texCoords)
    file << "vt " << t.x << ' ' << t.y << '\n';
  for (const Vec3f n : mesh.normals)
    file << "vn " << n << '\n';
  for (const auto& polygon : mesh.polygons) {
    file << 'f';
    for (const std::uint32_t v : polygon) {
      file << ' ' << v + 1;
      if (!mesh.texCoords.empty())
        file << '/' << v + 1 << '/' << v + 1;
      else if (!mesh.normals.empty())
        file << "//" << v + 1;
    }
    file << '\n';
  }
}

void writeOff(const GeneratedMesh& mesh, const std::string& path)
{
  MeshFile file(path);
  file << "OFF\n" << mesh.positions.size() << ' ' << mesh.polygons.size() << " 0\n";
  for (const Vec3f p : mesh.positions)
    file << p << '\n';
  for (const auto& polygon : mesh.polygons) {
    file << polygon.size();
    for (const std::uint32_t v : polygon)
      file << ' ' << v;
    file << '\n';
  }
}

void writePly(const GeneratedMesh& mesh, const std::string& path)
{
  MeshFile file(path);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.positions.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n"
          "property float ny\nproperty float nz\nelement face "
       << mesh.polygons.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    file.bytes(mesh.positions[v]);
    file.bytes(mesh.normals[v]);
  }
  for (const auto& polygon : mesh.polygons) {
    file.bytes(static_cast<std::uint8_t>(polygon.size()));
    for (const std::uint32_t v : polygon)
      file.bytes(static_cast<std::int32_t>(v));
  }
}

void writeStl(const GeneratedMesh& mesh, const std::string& path)
{
  MeshFile file(path);
  const auto triangles = mesh.triangles();
  char header[80] = "Limn";
  for (const char c : header)
    file.bytes(c);
  file.bytes(static_cast<std::uint32_t>(triangles.size()));
  for (const auto& triangle : triangles) {
    const Vec3f a = mesh.positions[triangle.vertex[0]], b = mesh.positions[triangle.vertex[1]],
                c = mesh.positions[triangle.vertex[2]];
    file.bytes(limn::normalized(limn::cross(b - a, c - a)));
    for (const Vec3f p : {a, b, c})
      file.bytes(p);
    file.bytes(std::uint16_t{0});
  }
}

float heightAt(Vec3f p)
{
  return p.y;
}
int regionOf(std::size_t quad, int side)
{
  const int column = static_cast<int>(quad) % side, row = static_cast<int>(quad) / side;
  return (column * 4 / side + row * 4 / side) % 4;
}

/// A sheet with the point array `height` and the cell array `region`, in VTK's legacy format.
void writeLegacyVtk(const GeneratedMesh& mesh, int side, const std::string& path)
{
  MeshFile file(path);
  file << "# vtk DataFile Version 3.0\nwaves\nASCII\nDATASET POLYDATA\nPOINTS "
       << mesh.positions.size() << " float\n";
  for (const Vec3f p : mesh.positions)
    file << p << '\n';
  file << "POLYGONS " << mesh.polygons.size() << ' ' << 5 * mesh.polygons.size() << '\n';
  for (const auto& q : mesh.polygons)
    file << "4 " << q[0] << ' ' << q[1] << ' ' << q[2] << ' ' << q[3] << '\n';
  file << "CELL_DATA " << mesh.polygons.size() << "\nSCALARS region int 1\nLOOKUP_TABLE default\n";
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i)
    file << regionOf(i, side) << '\n';
  file << "POINT_DATA " << mesh.positions.size()
       << "\nSCALARS height float 1\nLOOKUP_TABLE default\n";
  for (const Vec3f p : mesh.positions)
    file << heightAt(p) << '\n';
  file << "NORMALS Normals float\n";
  for (const Vec3f n : mesh.normals)
    file << n << '\n';
}

/// The same as VTK's XML.
void writeVtp(const GeneratedMesh& mesh, int side, const std::string& path)
{
  MeshFile file(path);
  const auto openArray = [&](const char* type, const char* name, int components) {
    file << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
         << components << "\" format=\"ascii\">\n";
  };
  const auto closeArray = [&] { file << "</DataArray>\n"; };
  file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
          "byte_order=\"LittleEndian\">\n<PolyData>\n<Piece NumberOfPoints=\""
       << mesh.positions.size() << "\" NumberOfPolys=\"" << mesh.polygons.size()
       << "\">\n<PointData Scalars=\"height\" Normals=\"Normals\">\n";
  openArray("Float32", "height", 1);
  for (const Vec3f p : mesh.positions)
    file << heightAt(p) << '\n';
  closeArray();
  openArray("Float32", "Normals", 3);
  for (const Vec3f n : mesh.normals)
    file << n << '\n';
  closeArray();
  file << "</PointData>\n<CellData>\n";
  openArray("Int32", "region", 1);
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i)
    file << regionOf(i, side) << '\n';
  closeArray();
  file << "</CellData>\n<Points>\n";
  openArray("Float32", "Points", 3);
  for (const Vec3f p : mesh.positions)
    file << p << '\n';
  closeArray();
  file << "</Points>\n<Polys>\n";
  openArray("Int64", "connectivity", 1);
  for (const auto& q : mesh.polygons)
    file << q[0] << ' ' << q[1] << ' ' << q[2] << ' ' << q[3] << '\n';
  closeArray();
  openArray("Int64", "offsets", 1);
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i)
    file << 4 * (i + 1) << '\n';
  closeArray();
  file << "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace

int main(int argc, char* argv[])
{
  if (argc != 2) {
    std::cerr << "usage: limn_generate_meshes FOLDER\n";
    return 2;
  }
  const std::string folder = std::string(argv[1]) + "/";
  constexpr int kWavesSide = 48;
  writeObj(limn::teapot(10), folder + "teapot.obj");
  writePly(limn::sphere(64, 32, 1), folder + "sphere.ply");
  writePly(limn::rock(128, 64), folder + "rock.ply");
  writeOff(limn::torus(64, 32, 1, 0.4), folder + "torus.off");
  writeStl(limn::gear(16, 0.4), folder + "gear.stl");
  writeObj(limn::knot(160, 20, 0.45), folder + "knot.obj");
  writeObj(limn::extrudedSine(64, 16), folder + "sine.obj");
  writeOff(limn::sheet(32), folder + "sheet.off");
  writeLegacyVtk(limn::sheet(kWavesSide), kWavesSide, folder + "waves.vtk");
  writeVtp(limn::sheet(kWavesSide), kWavesSide, folder + "waves.vtp");
  writeObj(limn::cube(), folder + "cube.obj");
  writeObj(limn::globe(48, 24), folder + "globe.obj");
  writeObj(limn::board(8), folder + "board.obj");
  return 0;
}
