// closed_form_rows.h: a case against what is true of it without any renderer.
#pragma once

#include "reports/band_rows.h"
#include "reports/study.h"

namespace litmus {

/// Adds the rows of the closed forms that the scene expects to study.comparisons, and those between
/// them and the case's references to study.pairs; the layers of `entry` get what is known of them
/// (CaseLayer::exact). `entry` is `scene` as it was rendered and obtained. Rows of pixels are as in
/// compare_layer(), over the pixels that are known, in regions that have any; no edge pixel is
/// excused. A claim's row counts the pixels where it does not hold
/// (`over_tolerance`); a figure's row has |measured - exact| as `max_abs`. A scene without [expect]
/// gets no row; one that an oracle refuses gets a skipped one, which says why. Of a spectral scene,
/// whose pictures per band are `bands` (null for RGB), a row is that of the worst three bands.
void compare_with_closed_form(const Scene& scene, Case& entry, const BandSide* bands, Study& study);

}  // namespace litmus
