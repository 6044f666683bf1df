// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnShaderProperty.h"

#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkLimnShaderProperty);

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::AddVertexShaderReplacement(const std::string& originalValue,
  bool replaceFirst, const std::string& replacementValue, bool replaceAll)
{
  this->Add({ "Vertex", originalValue, replaceFirst, replacementValue, replaceAll });
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::ClearVertexShaderReplacement(
  const std::string& originalValue, bool replaceFirst)
{
  this->Clear("Vertex", originalValue, replaceFirst);
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::ClearAllVertexShaderReplacements()
{
  this->ClearAll("Vertex");
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::AddFragmentShaderReplacement(const std::string& originalValue,
  bool replaceFirst, const std::string& replacementValue, bool replaceAll)
{
  this->Add({ "Fragment", originalValue, replaceFirst, replacementValue, replaceAll });
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::ClearFragmentShaderReplacement(
  const std::string& originalValue, bool replaceFirst)
{
  this->Clear("Fragment", originalValue, replaceFirst);
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::ClearAllFragmentShaderReplacements()
{
  this->ClearAll("Fragment");
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::AddGeometryShaderReplacement(const std::string& originalValue,
  bool replaceFirst, const std::string& replacementValue, bool replaceAll)
{
  this->Add({ "Geometry", originalValue, replaceFirst, replacementValue, replaceAll });
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::ClearGeometryShaderReplacement(
  const std::string& originalValue, bool replaceFirst)
{
  this->Clear("Geometry", originalValue, replaceFirst);
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::ClearAllGeometryShaderReplacements()
{
  this->ClearAll("Geometry");
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::ClearAllShaderReplacements()
{
  this->Replacements.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkLimnShaderProperty::GetNumberOfShaderReplacements()
{
  return static_cast<int>(this->Replacements.size());
}

//------------------------------------------------------------------------------
std::string vtkLimnShaderProperty::GetNthShaderReplacementTypeAsString(vtkIdType index)
{
  if (index < 0 || index >= this->GetNumberOfShaderReplacements())
  {
    vtkErrorMacro("There is no shader replacement " << index << ".");
    return {};
  }
  return this->Replacements[static_cast<size_t>(index)].Shader;
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::GetNthShaderReplacement(vtkIdType index, std::string& name,
  bool& replaceFirst, std::string& replacementValue, bool& replaceAll)
{
  if (index < 0 || index >= this->GetNumberOfShaderReplacements())
  {
    vtkErrorMacro("There is no shader replacement " << index << ".");
    return;
  }
  const Replacement& replacement = this->Replacements[static_cast<size_t>(index)];
  name = replacement.Original;
  replaceFirst = replacement.First;
  replacementValue = replacement.Value;
  replaceAll = replacement.All;
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::Add(const Replacement& replacement)
{
  this->Clear(replacement.Shader, replacement.Original, replacement.First);
  this->Replacements.push_back(replacement);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::Clear(
  const std::string& shader, const std::string& original, bool first)
{
  const auto isNamed = [&](const Replacement& one)
  { return one.Shader == shader && one.Original == original && one.First == first; };
  this->Replacements.erase(
    std::remove_if(this->Replacements.begin(), this->Replacements.end(), isNamed),
    this->Replacements.end());
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::ClearAll(const std::string& shader)
{
  const auto isOf = [&](const Replacement& one) { return one.Shader == shader; };
  this->Replacements.erase(
    std::remove_if(this->Replacements.begin(), this->Replacements.end(), isOf),
    this->Replacements.end());
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkLimnShaderProperty::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Replacements: " << this->Replacements.size() << "\n";
}
