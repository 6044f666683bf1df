// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnEngine.h"

#include "Private/EngineState.h"

#include "vtkObjectFactory.h"

namespace
{
limn::bridge::EngineState& State()
{
  return limn::bridge::EngineState::instance();
}
}

vtkStandardNewMacro(vtkLimnEngine);

//------------------------------------------------------------------------------
void vtkLimnEngine::SetNumberOfThreads(int threads)
{
  State().options.threads = threads < 0 ? 0 : threads;
}

//------------------------------------------------------------------------------
int vtkLimnEngine::GetNumberOfThreads()
{
  return State().options.threads;
}

//------------------------------------------------------------------------------
bool vtkLimnEngine::SetInstructionSet(const std::string& name)
{
  State();
  return limn::useTarget(name);
}

//------------------------------------------------------------------------------
std::string vtkLimnEngine::GetInstructionSet()
{
  State();
  return limn::currentTarget();
}

//------------------------------------------------------------------------------
int vtkLimnEngine::GetNumberOfAvailableInstructionSets()
{
  return static_cast<int>(limn::availableTargets().size());
}

//------------------------------------------------------------------------------
std::string vtkLimnEngine::GetAvailableInstructionSet(int index)
{
  const std::vector<std::string> names = limn::availableTargets();
  return index >= 0 && static_cast<size_t>(index) < names.size() ? names[static_cast<size_t>(index)]
                                                                 : std::string();
}

//------------------------------------------------------------------------------
void vtkLimnEngine::SetUseReference(bool useReference)
{
  State().options.backend = useReference ? limn::Backend::kReference : limn::Backend::kPipeline;
}

//------------------------------------------------------------------------------
bool vtkLimnEngine::GetUseReference()
{
  return State().options.backend == limn::Backend::kReference;
}

//------------------------------------------------------------------------------
vtkIdType vtkLimnEngine::GetTriangles()
{
  return static_cast<vtkIdType>(State().figures().stats.triangles);
}

//------------------------------------------------------------------------------
vtkIdType vtkLimnEngine::GetVertices()
{
  return static_cast<vtkIdType>(State().figures().stats.vertices);
}

//------------------------------------------------------------------------------
vtkIdType vtkLimnEngine::GetClusters()
{
  return static_cast<vtkIdType>(State().figures().stats.clusters);
}

//------------------------------------------------------------------------------
vtkIdType vtkLimnEngine::GetBytes()
{
  return static_cast<vtkIdType>(State().figures().stats.bytes);
}

//------------------------------------------------------------------------------
double vtkLimnEngine::GetPrepareMilliseconds()
{
  return State().figures().prepareMilliseconds;
}

//------------------------------------------------------------------------------
double vtkLimnEngine::GetBinMilliseconds()
{
  return State().figures().stats.binMilliseconds;
}

//------------------------------------------------------------------------------
double vtkLimnEngine::GetTileMilliseconds()
{
  return State().figures().stats.tileMilliseconds;
}

//------------------------------------------------------------------------------
void vtkLimnEngine::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfThreads: " << GetNumberOfThreads() << "\n";
  os << indent << "InstructionSet: " << GetInstructionSet() << "\n";
  os << indent << "UseReference: " << (GetUseReference() ? "On\n" : "Off\n");
  os << indent << "Triangles: " << GetTriangles() << "\n";
  os << indent << "Vertices: " << GetVertices() << "\n";
  os << indent << "Clusters: " << GetClusters() << "\n";
  os << indent << "Bytes: " << GetBytes() << "\n";
  os << indent << "PrepareMilliseconds: " << GetPrepareMilliseconds() << "\n";
  os << indent << "BinMilliseconds: " << GetBinMilliseconds() << "\n";
  os << indent << "TileMilliseconds: " << GetTileMilliseconds() << "\n";
}
