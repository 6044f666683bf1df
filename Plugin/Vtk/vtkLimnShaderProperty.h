// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnShaderProperty
 * @brief   keeps shader replacements that no shader uses
 *
 * Limn has no shaders. Programs that set replacements, or copy props that may have some, find here
 * what they put in; it changes no picture.
 *
 * @sa
 * vtkLimnUniforms vtkLimnActor
 */

#ifndef vtkLimnShaderProperty_h
#define vtkLimnShaderProperty_h

#include "vtkLimnModule.h" // for export macro
#include "vtkShaderProperty.h"

#include <string> // for std::string
#include <vector> // for std::vector

class VTKLIMN_EXPORT vtkLimnShaderProperty : public vtkShaderProperty
{
public:
  static vtkLimnShaderProperty* New();
  vtkTypeMacro(vtkLimnShaderProperty, vtkShaderProperty);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void AddVertexShaderReplacement(const std::string& originalValue, bool replaceFirst,
    const std::string& replacementValue, bool replaceAll) override;
  void AddFragmentShaderReplacement(const std::string& originalValue, bool replaceFirst,
    const std::string& replacementValue, bool replaceAll) override;
  void AddGeometryShaderReplacement(const std::string& originalValue, bool replaceFirst,
    const std::string& replacementValue, bool replaceAll) override;

  int GetNumberOfShaderReplacements() override;
  std::string GetNthShaderReplacementTypeAsString(vtkIdType index) override;
  void GetNthShaderReplacement(vtkIdType index, std::string& name, bool& replaceFirst,
    std::string& replacementValue, bool& replaceAll) override;

  void ClearVertexShaderReplacement(const std::string& originalValue, bool replaceFirst) override;
  void ClearFragmentShaderReplacement(const std::string& originalValue, bool replaceFirst) override;
  void ClearGeometryShaderReplacement(const std::string& originalValue, bool replaceFirst) override;
  void ClearAllVertexShaderReplacements() override;
  void ClearAllFragmentShaderReplacements() override;
  void ClearAllGeometryShaderReplacements() override;
  void ClearAllShaderReplacements() override;

protected:
  vtkLimnShaderProperty() = default;
  ~vtkLimnShaderProperty() override = default;

private:
  vtkLimnShaderProperty(const vtkLimnShaderProperty&) = delete;
  void operator=(const vtkLimnShaderProperty&) = delete;

  struct Replacement
  {
    std::string Shader;
    std::string Original;
    bool First;
    std::string Value;
    bool All;
  };
  void Add(const Replacement& replacement);
  void Clear(const std::string& shader, const std::string& original, bool first);
  void ClearAll(const std::string& shader);

  std::vector<Replacement> Replacements;
};

#endif
