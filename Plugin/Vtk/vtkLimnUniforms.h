// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnUniforms
 * @brief   keeps shader variables that no shader uses
 *
 * See vtkLimnShaderProperty. Names, types and values can be read back as they were set.
 *
 * @sa
 * vtkLimnShaderProperty
 */

#ifndef vtkLimnUniforms_h
#define vtkLimnUniforms_h

#include "vtkLimnModule.h" // for export macro
#include "vtkUniforms.h"

#include <map>    // for std::map
#include <string> // for std::string
#include <vector> // for std::vector

class VTKLIMN_EXPORT vtkLimnUniforms : public vtkUniforms
{
public:
  static vtkLimnUniforms* New();
  vtkTypeMacro(vtkLimnUniforms, vtkUniforms);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkMTimeType GetUniformListMTime() override { return this->ListTime.GetMTime(); }
  void RemoveUniform(const char* name) override;
  void RemoveAllUniforms() override;

  ///@{
  /**
   * Values of a name are replaced. Getting one that is not there, or is of the other scalar type,
   * gives false and leaves the argument as it is.
   */
  void SetUniform(const char* name, vtkUniforms::TupleType type, int components,
    const std::vector<int>& value) override;
  void SetUniform(const char* name, vtkUniforms::TupleType type, int components,
    const std::vector<float>& value) override;
  bool GetUniform(const char* name, std::vector<int>& value) override;
  bool GetUniform(const char* name, std::vector<float>& value) override;

  void SetUniformi(const char* name, int v) override;
  void SetUniformf(const char* name, float v) override;
  void SetUniform2i(const char* name, const int v[2]) override;
  void SetUniform2f(const char* name, const float v[2]) override;
  void SetUniform3f(const char* name, const float v[3]) override;
  void SetUniform4f(const char* name, const float v[4]) override;
  void SetUniformMatrix3x3(const char* name, float* v) override;
  void SetUniformMatrix4x4(const char* name, float* v) override;

  void SetUniform1iv(const char* name, const int count, const int* f) override;
  void SetUniform1fv(const char* name, const int count, const float* f) override;
  void SetUniform2fv(const char* name, const int count, const float (*f)[2]) override;
  void SetUniform3fv(const char* name, const int count, const float (*f)[3]) override;
  void SetUniform4fv(const char* name, const int count, const float (*f)[4]) override;
  void SetUniformMatrix4x4v(const char* name, const int count, float* v) override;

  void SetUniform3f(const char* name, const double v[3]) override;
  void SetUniform3uc(const char* name, const unsigned char v[3]) override;
  void SetUniform4uc(const char* name, const unsigned char v[4]) override;
  void SetUniformMatrix(const char* name, vtkMatrix3x3* v) override;
  void SetUniformMatrix(const char* name, vtkMatrix4x4* v) override;

  bool GetUniformi(const char* name, int& v) override;
  bool GetUniformf(const char* name, float& v) override;
  bool GetUniform2i(const char* name, int v[2]) override;
  bool GetUniform2f(const char* name, float v[2]) override;
  bool GetUniform3f(const char* name, float v[3]) override;
  bool GetUniform4f(const char* name, float v[4]) override;
  bool GetUniformMatrix3x3(const char* name, float* v) override;
  bool GetUniformMatrix4x4(const char* name, float* v) override;

  bool GetUniform3f(const char* name, double v[3]) override;
  bool GetUniform3uc(const char* name, unsigned char v[3]) override;
  bool GetUniform4uc(const char* name, unsigned char v[4]) override;
  bool GetUniformMatrix(const char* name, vtkMatrix3x3* v) override;
  bool GetUniformMatrix(const char* name, vtkMatrix4x4* v) override;

  bool GetUniform1iv(const char* name, std::vector<int>& f) override;
  bool GetUniform1fv(const char* name, std::vector<float>& f) override;
  bool GetUniform2fv(const char* name, std::vector<float>& f) override;
  bool GetUniform3fv(const char* name, std::vector<float>& f) override;
  bool GetUniform4fv(const char* name, std::vector<float>& f) override;
  bool GetUniformMatrix4x4v(const char* name, std::vector<float>& f) override;
  ///@}

  int GetNumberOfUniforms() override;
  const char* GetNthUniformName(vtkIdType uniformIndex) override;
  int GetUniformScalarType(const char* name) override;
  TupleType GetUniformTupleType(const char* name) override;
  int GetUniformNumberOfComponents(const char* name) override;
  int GetUniformNumberOfTuples(const char* name) override;

protected:
  vtkLimnUniforms() = default;
  ~vtkLimnUniforms() override = default;

private:
  vtkLimnUniforms(const vtkLimnUniforms&) = delete;
  void operator=(const vtkLimnUniforms&) = delete;

  struct Uniform
  {
    TupleType Type = TupleTypeInvalid;
    int Components = 0;
    std::vector<int> Ints;     ///< this one is filled ...
    std::vector<float> Floats; ///< ... or that one
  };
  void Set(const char* name, const Uniform& uniform);
  void SetFloats(const char* name, TupleType type, int components, const float* values, int tuples);
  const Uniform* Find(const char* name) const;
  bool CopyFloats(const char* name, float* values, size_t count) const;

  std::map<std::string, Uniform> Uniforms;
  vtkTimeStamp ListTime;
};

#endif
