// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnUniforms.h"

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <iterator>

vtkStandardNewMacro(vtkLimnUniforms);

//------------------------------------------------------------------------------
void vtkLimnUniforms::Set(const char* name, const Uniform& uniform)
{
  if (!name)
  {
    vtkErrorMacro("A uniform needs a name.");
    return;
  }
  if (this->Uniforms.count(name) == 0)
  {
    this->ListTime.Modified();
  }
  this->Uniforms[name] = uniform;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetFloats(
  const char* name, TupleType type, int components, const float* values, int tuples)
{
  const size_t count = static_cast<size_t>(components) * std::max(tuples, 0);
  this->Set(name, { type, components, {}, std::vector<float>(values, values + count) });
}

//------------------------------------------------------------------------------
const vtkLimnUniforms::Uniform* vtkLimnUniforms::Find(const char* name) const
{
  const auto found = this->Uniforms.find(name ? name : "");
  return found == this->Uniforms.end() ? nullptr : &found->second;
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::CopyFloats(const char* name, float* values, size_t count) const
{
  const Uniform* uniform = this->Find(name);
  if (!uniform || uniform->Floats.size() != count)
  {
    return false;
  }
  std::copy(uniform->Floats.begin(), uniform->Floats.end(), values);
  return true;
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::RemoveUniform(const char* name)
{
  if (name && this->Uniforms.erase(name) > 0)
  {
    this->ListTime.Modified();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::RemoveAllUniforms()
{
  this->Uniforms.clear();
  this->ListTime.Modified();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform(
  const char* name, TupleType type, int components, const std::vector<int>& value)
{
  this->Set(name, { type, components, value, {} });
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform(
  const char* name, TupleType type, int components, const std::vector<float>& value)
{
  this->Set(name, { type, components, {}, value });
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform(const char* name, std::vector<int>& value)
{
  const Uniform* uniform = this->Find(name);
  if (!uniform || uniform->Ints.empty())
  {
    return false;
  }
  value = uniform->Ints;
  return true;
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform(const char* name, std::vector<float>& value)
{
  const Uniform* uniform = this->Find(name);
  if (!uniform || uniform->Floats.empty())
  {
    return false;
  }
  value = uniform->Floats;
  return true;
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniformi(const char* name, int v)
{
  this->Set(name, { TupleTypeScalar, 1, { v }, {} });
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniformf(const char* name, float v)
{
  this->Set(name, { TupleTypeScalar, 1, {}, { v } });
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform2i(const char* name, const int v[2])
{
  this->Set(name, { TupleTypeVector, 2, { v[0], v[1] }, {} });
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform2f(const char* name, const float v[2])
{
  this->SetFloats(name, TupleTypeVector, 2, v, 1);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform3f(const char* name, const float v[3])
{
  this->SetFloats(name, TupleTypeVector, 3, v, 1);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform4f(const char* name, const float v[4])
{
  this->SetFloats(name, TupleTypeVector, 4, v, 1);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniformMatrix3x3(const char* name, float* v)
{
  this->SetFloats(name, TupleTypeMatrix, 9, v, 1);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniformMatrix4x4(const char* name, float* v)
{
  this->SetFloats(name, TupleTypeMatrix, 16, v, 1);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform1iv(const char* name, const int count, const int* f)
{
  this->Set(name, { TupleTypeScalar, 1, std::vector<int>(f, f + std::max(count, 0)), {} });
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform1fv(const char* name, const int count, const float* f)
{
  this->SetFloats(name, TupleTypeScalar, 1, f, count);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform2fv(const char* name, const int count, const float (*f)[2])
{
  this->SetFloats(name, TupleTypeVector, 2, f[0], count);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform3fv(const char* name, const int count, const float (*f)[3])
{
  this->SetFloats(name, TupleTypeVector, 3, f[0], count);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform4fv(const char* name, const int count, const float (*f)[4])
{
  this->SetFloats(name, TupleTypeVector, 4, f[0], count);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniformMatrix4x4v(const char* name, const int count, float* v)
{
  this->SetFloats(name, TupleTypeMatrix, 16, v, count);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform3f(const char* name, const double v[3])
{
  const float values[3] = { static_cast<float>(v[0]), static_cast<float>(v[1]),
    static_cast<float>(v[2]) };
  this->SetUniform3f(name, values);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform3uc(const char* name, const unsigned char v[3])
{
  const float values[3] = { v[0] / 255.0f, v[1] / 255.0f, v[2] / 255.0f };
  this->SetUniform3f(name, values);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniform4uc(const char* name, const unsigned char v[4])
{
  const float values[4] = { v[0] / 255.0f, v[1] / 255.0f, v[2] / 255.0f, v[3] / 255.0f };
  this->SetUniform4f(name, values);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniformMatrix(const char* name, vtkMatrix3x3* v)
{
  float values[9];
  std::transform(v->GetData(), v->GetData() + 9, values,
    [](double element) { return static_cast<float>(element); });
  this->SetUniformMatrix3x3(name, values);
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::SetUniformMatrix(const char* name, vtkMatrix4x4* v)
{
  float values[16];
  std::transform(v->GetData(), v->GetData() + 16, values,
    [](double element) { return static_cast<float>(element); });
  this->SetUniformMatrix4x4(name, values);
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniformi(const char* name, int& v)
{
  const Uniform* uniform = this->Find(name);
  if (!uniform || uniform->Ints.size() != 1)
  {
    return false;
  }
  v = uniform->Ints[0];
  return true;
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniformf(const char* name, float& v)
{
  return this->CopyFloats(name, &v, 1);
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform2i(const char* name, int v[2])
{
  const Uniform* uniform = this->Find(name);
  if (!uniform || uniform->Ints.size() != 2)
  {
    return false;
  }
  v[0] = uniform->Ints[0];
  v[1] = uniform->Ints[1];
  return true;
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform2f(const char* name, float v[2])
{
  return this->CopyFloats(name, v, 2);
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform3f(const char* name, float v[3])
{
  return this->CopyFloats(name, v, 3);
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform4f(const char* name, float v[4])
{
  return this->CopyFloats(name, v, 4);
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniformMatrix3x3(const char* name, float* v)
{
  return this->CopyFloats(name, v, 9);
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniformMatrix4x4(const char* name, float* v)
{
  return this->CopyFloats(name, v, 16);
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform3f(const char* name, double v[3])
{
  float values[3];
  if (!this->CopyFloats(name, values, 3))
  {
    return false;
  }
  std::copy(std::begin(values), std::end(values), v);
  return true;
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform3uc(const char* name, unsigned char v[3])
{
  float values[3];
  if (!this->CopyFloats(name, values, 3))
  {
    return false;
  }
  std::transform(std::begin(values), std::end(values), v,
    [](float value) { return static_cast<unsigned char>(value * 255.0f + 0.5f); });
  return true;
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform4uc(const char* name, unsigned char v[4])
{
  float values[4];
  if (!this->CopyFloats(name, values, 4))
  {
    return false;
  }
  std::transform(std::begin(values), std::end(values), v,
    [](float value) { return static_cast<unsigned char>(value * 255.0f + 0.5f); });
  return true;
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniformMatrix(const char* name, vtkMatrix3x3* v)
{
  float values[9];
  if (!this->CopyFloats(name, values, 9))
  {
    return false;
  }
  double elements[9];
  std::copy(std::begin(values), std::end(values), elements);
  v->DeepCopy(elements);
  return true;
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniformMatrix(const char* name, vtkMatrix4x4* v)
{
  float values[16];
  if (!this->CopyFloats(name, values, 16))
  {
    return false;
  }
  double elements[16];
  std::copy(std::begin(values), std::end(values), elements);
  v->DeepCopy(elements);
  return true;
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform1iv(const char* name, std::vector<int>& f)
{
  return this->GetUniform(name, f);
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform1fv(const char* name, std::vector<float>& f)
{
  return this->GetUniform(name, f);
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform2fv(const char* name, std::vector<float>& f)
{
  return this->GetUniform(name, f);
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform3fv(const char* name, std::vector<float>& f)
{
  return this->GetUniform(name, f);
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniform4fv(const char* name, std::vector<float>& f)
{
  return this->GetUniform(name, f);
}

//------------------------------------------------------------------------------
bool vtkLimnUniforms::GetUniformMatrix4x4v(const char* name, std::vector<float>& f)
{
  return this->GetUniform(name, f);
}

//------------------------------------------------------------------------------
int vtkLimnUniforms::GetNumberOfUniforms()
{
  return static_cast<int>(this->Uniforms.size());
}

//------------------------------------------------------------------------------
const char* vtkLimnUniforms::GetNthUniformName(vtkIdType uniformIndex)
{
  if (uniformIndex < 0 || uniformIndex >= this->GetNumberOfUniforms())
  {
    vtkErrorMacro("There is no uniform " << uniformIndex << ".");
    return nullptr;
  }
  return std::next(this->Uniforms.begin(), uniformIndex)->first.c_str();
}

//------------------------------------------------------------------------------
int vtkLimnUniforms::GetUniformScalarType(const char* name)
{
  const Uniform* uniform = this->Find(name);
  if (!uniform)
  {
    return VTK_VOID;
  }
  return uniform->Ints.empty() ? VTK_FLOAT : VTK_INT;
}

//------------------------------------------------------------------------------
vtkUniforms::TupleType vtkLimnUniforms::GetUniformTupleType(const char* name)
{
  const Uniform* uniform = this->Find(name);
  return uniform ? uniform->Type : TupleTypeInvalid;
}

//------------------------------------------------------------------------------
int vtkLimnUniforms::GetUniformNumberOfComponents(const char* name)
{
  const Uniform* uniform = this->Find(name);
  return uniform ? uniform->Components : 0;
}

//------------------------------------------------------------------------------
int vtkLimnUniforms::GetUniformNumberOfTuples(const char* name)
{
  const Uniform* uniform = this->Find(name);
  if (!uniform || uniform->Components <= 0)
  {
    return 0;
  }
  const size_t values = std::max(uniform->Ints.size(), uniform->Floats.size());
  return static_cast<int>(values / static_cast<size_t>(uniform->Components));
}

//------------------------------------------------------------------------------
void vtkLimnUniforms::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const auto& uniform : this->Uniforms)
  {
    os << indent << uniform.first << ": " << TupleTypeToString(uniform.second.Type) << " of "
       << uniform.second.Components << "\n";
  }
}
