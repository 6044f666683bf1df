// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnPostEffects
 * @brief   exposure, depth of field, bloom and tone mapping of a vtkLimnRenderer's picture
 *
 * Give it to vtkLimnRenderer::SetPostEffects(). The effects work on the renderer's viewport when
 * its surfaces are drawn, in the order of the name above, on colours that are not yet clamped to 1:
 * that of the surfaces, and what lies behind them (the background, or layers below). vtkRenderer's
 * FXAA comes after them. No effect encodes colours for a display: there is no gamma.
 *
 * With the initial values nothing is changed, and frames cost what they cost without.
 *
 * Effects are for Limn's own window. In an OpenGL window Limn's surfaces are one layer among VTK's
 * own, and VTK's render passes (vtkToneMappingPass, vtkDepthOfFieldPass, ...) and FXAA work on all
 * of them together.
 *
 * @sa
 * vtkLimnRenderer vtkFXAAOptions
 */

#ifndef vtkLimnPostEffects_h
#define vtkLimnPostEffects_h

#include "vtkLimnModule.h" // for export macro
#include "vtkObject.h"

class VTKLIMN_EXPORT vtkLimnPostEffects : public vtkObject
{
public:
  static vtkLimnPostEffects* New();
  vtkTypeMacro(vtkLimnPostEffects, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Factor of all colours, at least 0. Default: 1.
   */
  vtkSetMacro(Exposure, double);
  vtkGetMacro(Exposure, double);
  ///@}

  enum ToneMappings
  {
    TONE_MAPPING_NONE = 0,
    TONE_MAPPING_REINHARD,
    TONE_MAPPING_REINHARD_EXTENDED,
    TONE_MAPPING_ACES
  };

  ///@{
  /**
   * How colours c of luminance L become 0 to 1. None: they are clamped. Reinhard (2002):
   * c / (1 + L). Reinhard extended: c (1 + L / WhitePoint^2) / (1 + L). ACES: Narkowicz's fit
   * (2015) c (2.51 c + 0.03) / (c (2.43 c + 0.59) + 0.14). Default: None.
   */
  vtkSetClampMacro(ToneMapping, int, TONE_MAPPING_NONE, TONE_MAPPING_ACES);
  vtkGetMacro(ToneMapping, int);
  void SetToneMappingToNone() { this->SetToneMapping(TONE_MAPPING_NONE); }
  void SetToneMappingToReinhard() { this->SetToneMapping(TONE_MAPPING_REINHARD); }
  void SetToneMappingToReinhardExtended() { this->SetToneMapping(TONE_MAPPING_REINHARD_EXTENDED); }
  void SetToneMappingToAces() { this->SetToneMapping(TONE_MAPPING_ACES); }
  const char* GetToneMappingAsString();
  ///@}

  ///@{
  /**
   * The grey that the extended curve of Reinhard makes white, 0.001 to 65504. Default: 4.
   */
  vtkSetMacro(WhitePoint, double);
  vtkGetMacro(WhitePoint, double);
  ///@}

  ///@{
  /**
   * Light that spills over from pixels with a channel above BloomThreshold: so many times the part
   * above it is spread around the pixel. 0, the default, is no bloom. Default threshold: 1.
   */
  vtkSetMacro(BloomStrength, double);
  vtkGetMacro(BloomStrength, double);
  vtkSetMacro(BloomThreshold, double);
  vtkGetMacro(BloomThreshold, double);
  ///@}

  ///@{
  /**
   * How far the light spreads: each level of the pyramid, 1 to 8, doubles the width. The last is
   * about a Gaussian of 0.8 2^BloomLevels pixels. Default: 5.
   */
  vtkSetMacro(BloomLevels, int);
  vtkGetMacro(BloomLevels, int);
  ///@}

  ///@{
  /**
   * Blurs what is not in focus as a thin lens does. The lens is the camera's: FocalDisk is its
   * diameter in world coordinates, FocalDistance the distance in focus, or that of the focal point
   * where it is 0. Not with parallel projection. Default: off.
   */
  vtkSetMacro(DepthOfField, vtkTypeBool);
  vtkGetMacro(DepthOfField, vtkTypeBool);
  vtkBooleanMacro(DepthOfField, vtkTypeBool);
  ///@}

  ///@{
  /**
   * The largest radius of blur in pixels, 1 to 63: the work grows with its square. Default: 16.
   */
  vtkSetMacro(MaximumBlurRadius, int);
  vtkGetMacro(MaximumBlurRadius, int);
  ///@}

protected:
  vtkLimnPostEffects() = default;
  ~vtkLimnPostEffects() override = default;

private:
  vtkLimnPostEffects(const vtkLimnPostEffects&) = delete;
  void operator=(const vtkLimnPostEffects&) = delete;

  double Exposure = 1.0;
  int ToneMapping = TONE_MAPPING_NONE;
  double WhitePoint = 4.0;
  double BloomStrength = 0.0;
  double BloomThreshold = 1.0;
  int BloomLevels = 5;
  vtkTypeBool DepthOfField = 0;
  int MaximumBlurRadius = 16;
};

#endif
