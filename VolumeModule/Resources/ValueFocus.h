#ifndef Varimarch_Resources_ValueFocus_h
#define Varimarch_Resources_ValueFocus_h

#include "Frame/Frame.h"
#include "Resources/VolumeTexture.h"

#include <optional>
#include <vector>

namespace varimarch
{

/// The values of each component between which its look changes; none if all values matter.
std::vector<std::optional<ValueRange>> ValuesThatMatter(const Frame& frame);

/// Everything in a frame that these depend on.
Fingerprint ValueInputs(const Frame& frame);

/// The part of a range that lies within some widths of the values that matter; all of it if no
/// value does.
ValueRange NearValues(const ValueRange& all, const std::optional<ValueRange>& thatMatter);

/// The values at which a volume is opaque and beside which it has others: see OpaqueValues.
/// @param texels  those of its first component
std::vector<ValueRange> OpaqueValuesOf(const Frame& frame, const ScalarTexels& texels);

/// Checks that values which matter are not limited to LargestNumber.
/// @throws std::runtime_error with a sentence for the user, if they are
void CheckReach(const ScalarTexels& texels, const std::optional<ValueRange>& thatMatter);

/// A texel format whose tables, fields and texels tell apart the values that matter, although other
/// values, such as a fill value, may be very far away. The present format is kept if it does that,
/// because another one costs an upload.
/// @param all  the format of all values of a component
ScalarTexels Focused(const ScalarTexels& all, const ScalarTexels& present,
  const std::optional<ValueRange>& thatMatter);

/// True if the texels of a sum or mean do not tell apart the values between which its look changes.
/// All values count in it, so that its texels cannot be focused.
bool MergesValues(const Frame& frame, const std::vector<ScalarTexels>& texels);

}

#endif
