#include "Readers/Dicom/Metadata.h"

#include "Readers/Dicom/Attributes.h"
#include "Readers/Dicom/FileHeader.h"
#include "Readers/Dicom/UptakeValue.h"

#include <vtkDICOMDictHash.h>

namespace varimarch
{
namespace
{

/// Determines the weighting from the sequence's times; empty for times in between.
std::string WeightingOf(const DicomAttributes& attributes)
{
  constexpr double ShortestEchoMsOfT2 = 60.0;
  constexpr double LongestEchoMsOfT1 = 30.0;
  constexpr double LongestRepetitionMsOfT1 = 1000.0;
  if (attributes.Text(DC::AngioFlag) == "Y")
  {
    return "angiography";
  }
  const double echoMs = attributes.NumberOr(DC::EchoTime, 0.0);
  const double repetitionMs = attributes.NumberOr(DC::RepetitionTime, 0.0);
  if (echoMs >= ShortestEchoMsOfT2)
  {
    return "T2";
  }
  const bool isShort = echoMs <= LongestEchoMsOfT1 && repetitionMs <= LongestRepetitionMsOfT1;
  return echoMs > 0.0 && repetitionMs > 0.0 && isShort ? "T1" : "";
}

}

DicomMetadata MetadataOf(const std::string& path, int frame)
{
  const DicomHeader header = ReadDicomHeader(path);
  DicomMetadata metadata;
  if (!header.file)
  {
    return metadata;
  }
  const DicomAttributes attributes(header.meta, frame);
  metadata.modality = attributes.Text(DC::Modality);
  metadata.bodyPart = attributes.Text(DC::BodyPartExamined);
  metadata.hasContrastAgent = !attributes.Text(DC::ContrastBolusAgent).empty();
  if (metadata.modality == "MR")
  {
    metadata.weighting = WeightingOf(attributes);
  }
  const UptakeValue uptake = UptakeValueOf(attributes);
  metadata.uptakeValueFactor = uptake.factor;
  metadata.uptakeDoubt = uptake.doubt;
  const double window = attributes.NumberOr(DC::WindowWidth, 0.0);
  if (window > 0)
  {
    metadata.windowLevel = { window, attributes.NumberOr(DC::WindowCenter, 0.0) };
  }
  metadata.isInverted = attributes.Text(DC::PhotometricInterpretation) == "MONOCHROME1" ||
    attributes.Text(DC::PresentationLUTShape) == "INVERSE";
  return metadata;
}

}
