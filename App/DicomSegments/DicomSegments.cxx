#include "DicomSegments/DicomSegments.h"

#include "DicomSegments/ScanImages.h"
#include "Scene/Files/OutputFile.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmfg/fgderimg.h>
#include <dcmtk/dcmfg/fgfracon.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanor.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmiod/cielabutil.h>
#include <dcmtk/dcmiod/iodreferences.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>
#include <dcmtk/oflog/oflog.h>

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>

namespace varimarch
{

namespace
{

constexpr std::size_t LongestLabel = 64; // characters of the VR "LO"

// DCMTK's reason, as an error about a file.
void Require(const OFCondition& condition, const std::string& path)
{
  if (condition.bad())
  {
    throw std::runtime_error(path + ": cannot write the segments as DICOM: " + condition.text() +
      "; save them as .seg.nrrd instead");
  }
}

// A name as the label of a segment: DICOM separates values by backslashes.
OFString LabelOf(const Segment& segment)
{
  std::string label = segment.name.empty() ? NameOfLabel(segment.value) : segment.name;
  std::replace(label.begin(), label.end(), '\\', '/');
  std::size_t characters = 0;
  std::size_t bytes = 0;
  for (; bytes < label.size(); ++bytes)
  {
    // All bytes of a character of UTF-8 after its first begin with 10.
    characters += (static_cast<unsigned char>(label[bytes]) & 0xC0) != 0x80 ? 1 : 0;
    if (characters > LongestLabel)
    {
      break;
    }
  }
  return { label.c_str(), bytes };
}

/// An image of the scan.
struct SourceImage
{
  ImageSOPInstanceReferenceMacro reference;
  std::optional<glm::dvec3> placeMm; ///< place of its first pixel; empty for several frames
};

SourceImage SourceOf(const std::string& image)
{
  DcmFileFormat file = ImageOfScan(image);
  DcmDataset& scan = *file.getDataset();
  const ImageUids uids = UidsOf(scan);
  SourceImage source;
  source.reference.setReferencedSOPClassUID(uids.ofClass);
  source.reference.setReferencedSOPInstanceUID(uids.ofInstance);
  glm::dvec3 place;
  const bool hasPlace = scan.findAndGetFloat64(DCM_ImagePositionPatient, place.x, 0).good() &&
    scan.findAndGetFloat64(DCM_ImagePositionPatient, place.y, 1).good() &&
    scan.findAndGetFloat64(DCM_ImagePositionPatient, place.z, 2).good();
  source.placeMm = hasPlace ? std::optional(place) : std::nullopt;
  return source;
}

// The images that a slice was drawn on: that at its place, or all that have several frames.
OFVector<ImageSOPInstanceReferenceMacro> SourcesAt(
  const glm::dvec3& placeMm, double withinMm, const std::vector<SourceImage>& sources)
{
  OFVector<ImageSOPInstanceReferenceMacro> found;
  for (const SourceImage& source : sources)
  {
    if (!source.placeMm || glm::distance(*source.placeMm, placeMm) < withinMm)
    {
      found.push_back(source.reference);
    }
  }
  return found;
}

std::unique_ptr<DcmSegmentation> NewSegmentation(
  const std::array<int, 3>& size, const std::string& path)
{
  constexpr int MostPixels = std::numeric_limits<Uint16>::max();
  if (size[0] > MostPixels || size[1] > MostPixels)
  {
    throw std::runtime_error(path + ": expected slices of at most 65535 pixels a side, found " +
      std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      "; save the segments as .seg.nrrd instead");
  }
  DcmSegmentation* made = nullptr;
  const ContentIdentificationMacro content("1", "SEGMENTATION", "Segments of a scan", "");
  Require(DcmSegmentation::createBinarySegmentation(made, Uint16(size[1]), Uint16(size[0]),
            { "Varimarch", "varimarch-viewer", "1", "1" }, content),
    path);
  return std::unique_ptr<DcmSegmentation>(made);
}

void AddSegment(const Segment& segment, DcmSegmentation& segmentation, const std::string& path)
{
  // SNOMED's code for any tissue, since nobody is asked what a segment is.
  const CodeSequenceMacro tissue("85756007", "SCT", "Tissue");
  DcmSegment* made = nullptr;
  Require(DcmSegment::create(
            made, "Segment", tissue, tissue, DcmSegTypes::SAT_SEMIAUTOMATIC, "Varimarch"),
    path);
  std::unique_ptr<DcmSegment> owned(made);
  double lab[3];
  IODCIELabUtil::rgb2DicomLab(lab[0], lab[1], lab[2], segment.rgb.r, segment.rgb.g, segment.rgb.b);
  Require(
    made->setRecommendedDisplayCIELabValue(Uint16(lab[0]), Uint16(lab[1]), Uint16(lab[2])), path);
  Uint16 number = 0;
  Require(segmentation.addSegment(made, number), path);
  static_cast<void>(owned.release());
}

// The grid that all frames share.
void AddGrid(vtkImageData* grid, DcmSegmentation& segmentation, const std::string& path)
{
  const double* const spacing = grid->GetSpacing();
  const vtkMatrix3x3* const axes = grid->GetDirectionMatrix();
  const auto part = [&](int row, int axis) { return Decimal(axes->GetElement(row, axis)); };
  FGPixelMeasures measures;
  Require(measures.setPixelSpacing(Decimal(spacing[1]) + "\\" + Decimal(spacing[0])), path);
  Require(measures.setSliceThickness(Decimal(spacing[2])), path);
  Require(measures.setSpacingBetweenSlices(Decimal(spacing[2])), path);
  Require(segmentation.addForAllFrames(measures), path);
  const std::unique_ptr<FGPlaneOrientationPatient> orientation(
    FGPlaneOrientationPatient::createMinimal(
      part(0, 0), part(1, 0), part(2, 0), part(0, 1), part(1, 1), part(2, 1)));
  Require(segmentation.addForAllFrames(*orientation), path);
  OFString organization;
  std::array<char, 100> uid;
  organization = dcmGenerateUniqueIdentifier(uid.data());
  IODMultiframeDimensionModule& dimensions = segmentation.getDimensions();
  Require(dimensions.addDimensionIndex(DCM_ReferencedSegmentNumber, organization,
            DCM_SegmentIdentificationSequence, "Segment"),
    path);
  Require(dimensions.addDimensionIndex(
            DCM_ImagePositionPatient, organization, DCM_PlanePositionSequence, "Position"),
    path);
}

/// The pixels of a segment in a slice.
struct Mask
{
  Uint16 segment; ///< number of the segment
  int slice;
  std::vector<Uint8> pixels; ///< 1 inside, 0 outside
};

void AddFrame(Mask& mask, vtkImageData* grid, const std::vector<SourceImage>& sources,
  DcmSegmentation& segmentation, const std::string& path)
{
  glm::dvec3 place;
  grid->TransformIndexToPhysicalPoint(0, 0, mask.slice, &place.x);
  const std::unique_ptr<FGPlanePosPatient> position(
    FGPlanePosPatient::createMinimal(Decimal(place.x), Decimal(place.y), Decimal(place.z)));
  FGFrameContent content;
  Require(content.setDimensionIndexValues(mask.segment, 0), path);
  Require(content.setDimensionIndexValues(Uint32(mask.slice) + 1, 1), path);
  OFVector<FGBase*> groups;
  groups.push_back(position.get());
  groups.push_back(&content);
  const OFVector<ImageSOPInstanceReferenceMacro> images =
    SourcesAt(place, 0.5 * grid->GetSpacing()[2], sources);
  std::unique_ptr<FGBase> derivation;
  if (!images.empty())
  {
    derivation.reset(DcmSegmentation::createDerivationImageFG(images, "Segments of a scan"));
    groups.push_back(derivation.get());
  }
  Require(segmentation.addFrame(mask.pixels.data(), mask.segment, groups), path);
}

// One frame for each slice that a segment is in, segment by segment.
void AddFrames(vtkImageData* numbers, const std::vector<SourceImage>& sources,
  DcmSegmentation& segmentation, const std::string& path)
{
  const int segmentCount = int(segmentation.getNumberOfSegments());
  const int* const size = numbers->GetDimensions();
  const std::size_t inSlice = std::size_t(size[0]) * std::size_t(size[1]);
  const auto* const first = static_cast<const std::uint8_t*>(numbers->GetScalarPointer());
  bool hasVoxels = false;
  Mask mask = { 0, 0, std::vector<Uint8>(inSlice) };
  for (int segment = 1; segment <= segmentCount; ++segment)
  {
    mask.segment = Uint16(segment);
    for (mask.slice = 0; mask.slice < size[2]; ++mask.slice)
    {
      const std::uint8_t* const slice = first + std::size_t(mask.slice) * inSlice;
      std::transform(slice, slice + inSlice, mask.pixels.begin(),
        [=](std::uint8_t number) { return Uint8(number == segment ? 1 : 0); });
      if (std::find(mask.pixels.begin(), mask.pixels.end(), 1) != mask.pixels.end())
      {
        AddFrame(mask, numbers, sources, segmentation, path);
        hasVoxels = true;
      }
    }
  }
  if (!hasVoxels)
  {
    throw std::runtime_error(
      path + ": expected segments with voxels, found none; DICOM has no empty segmentations");
  }
}

// The patient, the study, the frame of reference, and the images that the segments are of.
void AddScan(
  const std::vector<std::string>& images, DcmSegmentation& segmentation, const std::string& path)
{
  DcmFileFormat image = ImageOfScan(images.front());
  DcmDataset& scan = *image.getDataset();
  ConvertTextsToUtf8(scan, images.front()); // as the names of the segments are
  Require(segmentation.importFromSourceImage(scan), path);
  Require(segmentation.getSeries().setSeriesDescription("Segments"), path);
  Require(segmentation.getSeries().setSeriesNumber("1"), path);
  OFString study;
  scan.findAndGetOFString(DCM_StudyInstanceUID, study);
  OFVector<OFString> files;
  for (const std::string& file : images)
  {
    files.push_back(file.c_str());
  }
  IODReferences references;
  references.addFromFiles(files);
  segmentation.getCommonInstanceReference().addReferences(references, study);
}

// Puts the names in, which DCMTK's own classes would take for ASCII.
void AddNames(const std::vector<Segment>& segments, DcmDataset& written, const std::string& path)
{
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    DcmItem* described = nullptr;
    Require(written.findAndGetSequenceItem(DCM_SegmentSequence, described, long(i)), path);
    Require(described->putAndInsertOFStringArray(DCM_SegmentLabel, LabelOf(segments[i])), path);
  }
}

}

void WriteDicomSegments(const LabelMap& labels, const std::vector<Segment>& segments,
  const std::vector<std::string>& images, const std::string& path)
{
  RequireNoImage(images, path);
  // DCMTK would print about each attribute that an old scanner left out.
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  std::array<int, 3> size;
  labels.image->GetDimensions(size.data());
  const std::unique_ptr<DcmSegmentation> segmentation = NewSegmentation(size, path);
  AddScan(images, *segmentation, path);
  for (const Segment& segment : segments)
  {
    AddSegment(segment, *segmentation, path);
  }
  AddGrid(labels.image, *segmentation, path);
  std::vector<SourceImage> sources;
  std::transform(images.begin(), images.end(), std::back_inserter(sources), SourceOf);
  AddFrames(labels.image, sources, *segmentation, path);
  DcmFileFormat file;
  Require(segmentation->writeDataset(*file.getDataset()), path);
  AddNames(segments, *file.getDataset(), path);
  WriteFileWhole(path,
    [&](const std::string& part)
    {
      Require(file.saveFile(part.c_str(), EXS_LittleEndianExplicit), path);
      return true;
    });
}

}
