// ssim.h: the structural similarity of two pictures.
//
// For triage only, never a gate. Source: Wang, Bovik, Sheikh, Simoncelli, "Image Quality
// Assessment: From Error Visibility to Structural Similarity" (2004), with its constants: an 11 x
// 11 Gaussian window of 1.5 pixels, K1 = 0.01, K2 = 0.03.
#pragma once

#include "scene/picture.h"

namespace litmus {

/// Mean SSIM of the luminance (Rec.709) as it is shown: clipped to [0, 1] and sRGB-encoded, dynamic
/// range 1. From -1 to 1; 1 for equal pictures. The mean is over the windows inside the picture; in
/// one smaller than a window, over all pixels, the border values continued. A pixel that is not
/// finite in either picture is black in both (Difference counts it). 1 for pictures without pixels.
/// Throws SizeMismatch.
double ssim(const Picture& ours, const Picture& theirs);

}  // namespace litmus
