// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/ParseNormalForm.h"

#include "Rendering/Mesh/Io/ArrayImporter.h"

#include <OpenMesh/Core/IO/reader/OBJReader.hh>
#include <OpenMesh/Core/IO/reader/OMReader.hh>
#include <OpenMesh/Core/IO/reader/PLYReader.hh>
#include <OpenMesh/Core/IO/reader/STLReader.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <istream>
#include <locale>
#include <mutex>
#include <streambuf>

namespace limn::meshio {
namespace {

/// Reads memory in place; a std::istringstream would copy it.
class MemoryBuffer : public std::streambuf {
 public:
  explicit MemoryBuffer(const std::string& bytes)
  {
    char* const begin = const_cast<char*>(bytes.data());
    setg(begin, begin, begin + bytes.size());
  }

 protected:
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override
  {
    const off_type base = from == std::ios_base::beg   ? 0
                          : from == std::ios_base::cur ? gptr() - eback()
                                                       : egptr() - eback();
    return seekpos(base + offset, std::ios_base::in);
  }
  pos_type seekpos(pos_type position, std::ios_base::openmode) override
  {
    const off_type offset = position;
    if (offset < 0 || offset > egptr() - eback()) return pos_type(off_type(-1));
    setg(eback(), eback() + offset, egptr());
    return position;
  }
};

/// OpenMesh prints its complaints; ours travel as Fault.
class Silence {
 public:
  Silence() : wasEnabled_(omerr().is_enabled()) { omerr().disable(); }
  ~Silence()
  {
    if (wasEnabled_) omerr().enable();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  bool wasEnabled_;
};

bool parse(Parser parser, std::istream& stream, ArrayImporter& importer)
{
  using OpenMesh::IO::Options;
  Options options = Options::VertexNormal;
  options += Options::VertexTexCoord;
  options += Options::VertexColor;
  options += Options::FaceColor;
  if (parser != Parser::kObj) options += Options::Binary;
  if (parser == Parser::kOm) options += Options::FaceTexCoord;
  switch (parser) {
    case Parser::kObj:
      return OpenMesh::IO::OBJReader().read(stream, importer, options);
    case Parser::kPly:
      return OpenMesh::IO::PLYReader().read(stream, importer, options);
    case Parser::kStl:
      return OpenMesh::IO::STLReader().read(stream, importer, options);
    case Parser::kOm:
      return OpenMesh::IO::OMReader().read(stream, importer, options);
  }
  return false;
}

/// OpenMesh's parser for OBJ reads numbers in the global C++ locale.
void requireDecimalPoint(const Source& source)
{
  const std::locale locale;
  const auto& punctuation = std::use_facet<std::numpunct<char>>(locale);
  if (punctuation.decimal_point() == '.' && punctuation.grouping().empty()) return;
  source.fail(
      "the program's global C++ locale writes numbers otherwise than OBJ files; set it to "
      "std::locale::classic()");
}

/// The check of the format has read every coordinate by itself.
void requireSameNumbers(const Source& source, const NormalForm& form, const RawMesh& mesh)
{
  bool isSame = form.positions.empty() || form.positions.size() == mesh.positions.size();
  for (std::size_t i = 0; isSame && i < form.positions.size(); ++i) {
    isSame = mesh.positions[i] == vec3Cast<float>(form.positions[i]);
  }
  if (!isSame) source.fail("OpenMesh's parser reads other coordinates than the file has");
}

}  // namespace

RawMesh parseNormalForm(Source& source, const NormalForm& form)
{
  static std::mutex oneAtATime;
  const std::lock_guard<std::mutex> lock(oneAtATime);
  const Silence silence;
  if (form.parser == Parser::kObj) requireDecimalPoint(source);
  MemoryBuffer buffer(form.bytes);
  std::istream stream(&buffer);
  stream.imbue(std::locale::classic());
  ArrayImporter importer(source, form);
  if (!parse(form.parser, stream, importer)) source.fail("OpenMesh's parser refuses the file");
  RawMesh mesh = importer.finishMesh();
  requireSameNumbers(source, form, mesh);
  return mesh;
}

}  // namespace limn::meshio
