// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnEngine
 * @brief   settings of Limn's rasterizer, and what it did in the last frame
 *
 * For the whole program. None of the settings changes a picture; they are for measuring and for
 * sharing a machine. The environment gives their first values: LIMN_THREADS, LIMN_INSTRUCTION_SET
 * and LIMN_RENDERER=reference.
 *
 * The figures of the last frame are sums over the renderers of the window that rendered last.
 *
 * @sa
 * vtkLimnPolyDataMapper vtkLimnRenderWindow
 */

#ifndef vtkLimnEngine_h
#define vtkLimnEngine_h

#include "vtkLimnModule.h" // for export macro
#include "vtkObject.h"

#include <string> // for std::string

class VTKLIMN_EXPORT vtkLimnEngine : public vtkObject
{
public:
  static vtkLimnEngine* New();
  vtkTypeMacro(vtkLimnEngine, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How many threads draw. 0, the default: as many as the machine has cores.
   */
  static void SetNumberOfThreads(int threads);
  static int GetNumberOfThreads();
  ///@}

  ///@{
  /**
   * The instruction set in use, one of those that GetAvailableInstructionSet() names, best first.
   * Setting "" takes the best one. False if the name is not available; then nothing changes.
   */
  static bool SetInstructionSet(const std::string& name);
  static std::string GetInstructionSet();
  static int GetNumberOfAvailableInstructionSets();
  static std::string GetAvailableInstructionSet(int index);
  ///@}

  ///@{
  /**
   * Draw with the plain, slow renderer against which the fast one is checked. Default: off.
   */
  static void SetUseReference(bool useReference);
  static bool GetUseReference();
  ///@}

  ///@{
  /**
   * Of the last frame: triangles and vertices of the meshes drawn, clusters they are kept in, bytes
   * of those and of the frame's own memory.
   */
  static vtkIdType GetTriangles();
  static vtkIdType GetVertices();
  static vtkIdType GetClusters();
  static vtkIdType GetBytes();
  ///@}

  ///@{
  /**
   * Of the last frame, in milliseconds: meshes taken over from VTK and clusters built, clusters
   * culled and sorted into tiles, tiles drawn.
   */
  static double GetPrepareMilliseconds();
  static double GetBinMilliseconds();
  static double GetTileMilliseconds();
  ///@}

protected:
  vtkLimnEngine() = default;
  ~vtkLimnEngine() override = default;

private:
  vtkLimnEngine(const vtkLimnEngine&) = delete;
  void operator=(const vtkLimnEngine&) = delete;
};

#endif
