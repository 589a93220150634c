#include "Scene/Json/SceneFields.h"

#include "Scene/Segments/LabelMap.h"

#include <algorithm>

namespace varimarch
{

namespace
{

void RequireOtherValues(const JsonCursor& json, const std::vector<Segment>& segments)
{
  const int value = segments.back().value;
  if (std::any_of(segments.begin(), segments.end() - 1,
        [&](const Segment& other) { return other.value == value; }))
  {
    json.At("value").Fail(
      "expected another value for each segment, found " + std::to_string(value) + " twice");
  }
}

const Fields<Segment>& SegmentFields()
{
  static const Fields<Segment> fields("segment",
    [](Fields<Segment>& list)
    {
      list.Require("value", &Segment::value,
        Checked<int>(
          IntegerForm(SmallestLabel, LargestLabel), [](const int& value) { return value != 0; },
          "expected the value of a segment, found 0, which means no segment"),
        { "the label in the file, not 0" });
      list.Add("name", &Segment::name, TextForm(), { "for people" });
      list.Require("color", &Segment::rgb, ColorForm(), { "red, green, blue, each from 0 to 1" });
      list.Add("visible", &Segment::visible, BooleanForm(), { "`true` or `false`" });
      list.Add("opacity", &Segment::opacity, NumberForm(UnitInterval),
        { "opacity of its mean thickness, 0 to 1" });
    });
  return fields;
}

const Fields<SceneLabels>& LabelsFields()
{
  static const Fields<SceneLabels> fields("labels",
    [](Fields<SceneLabels>& list)
    {
      list.Require("file", &SceneLabels::path, TextForm(),
        { "a segmentation (DICOM SEG, `.seg.nrrd`) or a volume of any format whose values are "
          "labels; a relative path starts at the scene's folder" });
      list
        .Add("series", &SceneLabels::series, TextForm(),
          { "the DICOM series, as in `volume`", "", "the first segmentation" })
        .OmitDefault();
      list.Add("segments", &SceneLabels::segments, SegmentsForm(),
        { "the look of segments", "", "as the file says, and visible and opaque" });
    });
  return fields;
}

const Fields<Placement>& PlacementFields()
{
  static const Fields<Placement> fields("placement",
    [](Fields<Placement>& list)
    {
      list.Add("turn", &Placement::turnDegrees, NumbersForm<3>(),
        { "turns it about x, then y, then z, through the middle of the volume's box", "degrees" });
      list.Add("move", &Placement::moveMm, NumbersForm<3>(), { "then moves it", "mm, LPS" });
    });
  return fields;
}

// The look of a volume over the first, of which only the transfer function and its shading count.
JsonForm<Look> OverlaidLookForm()
{
  const JsonForm<Preset> preset = PresetForm();
  return { [=](const JsonCursor& json, Look& look)
    {
      Preset read;
      preset.read(json, read);
      look = read.look;
    },
    [](const Look& look) { return LookFields().Write(look); }, preset.describe };
}

void AddAppearance(Fields<OverlaidVolume>& fields)
{
  fields.Add("visible", &OverlaidVolume::visible, BooleanForm(), { "`true` or `false`" });
  fields.Add("opacity", &OverlaidVolume::opacity, NumberForm(UnitInterval),
    { "factor of the opacities of the look, and of its part in slices, 0 to 1" });
  fields.Add("sliceColors", &OverlaidVolume::sliceColors, ChoiceForm(SliceColorsNames()),
    { "colours in slices, from the smallest to the largest value shown: `gray`, `hot` or "
      "`green`" });
  fields.Add("windowLevel", &OverlaidVolume::windowLevel, NumbersForm<2>(),
    { "as in `slices`", "", "from the file or the data" });
}

const Fields<OverlaidVolume>& OverlayFields()
{
  static const Fields<OverlaidVolume> fields("overlay",
    [](Fields<OverlaidVolume>& list)
    {
      list.Require("volume", &OverlaidVolume::source, VolumeForm(), { "as in the scene" });
      list.Require("look", &OverlaidVolume::look, OverlaidLookForm(), { "as in the scene" });
      list.Add("name", &OverlaidVolume::name, TextForm(), { "for people" });
      list.Add("placement", &OverlaidVolume::placement, ObjectForm(&PlacementFields),
        { "a rigid motion away from the patient coordinates", "", "none" });
      AddAppearance(list);
      list.Add("labels", &OverlaidVolume::labels, LabelsForm(),
        { "a segmentation of this volume, as above" });
    });
  return fields;
}

}

JsonForm<std::vector<Segment>> SegmentsForm()
{
  return ListForm(ObjectForm(&SegmentFields), 0, MostSegments, &RequireOtherValues);
}

JsonForm<SceneLabels> LabelsForm()
{
  return ObjectForm(&LabelsFields);
}

JsonForm<std::vector<OverlaidVolume>> OverlaysForm()
{
  return ListForm(ObjectForm(&OverlayFields), 0, MostVolumes - 1);
}

}
