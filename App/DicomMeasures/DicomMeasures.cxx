#include "DicomMeasures/DicomMeasures.h"

#include "DicomSegments/ScanImages.h"
#include "Scene/Files/OutputFile.h"
#include "Scene/Measures/MeasureKinds.h"
#include "Scene/Volumes/VolumeLoading.h"

#include <dcmtk/dcmsr/dsrdoc.h>
#include <dcmtk/oflog/oflog.h>

#include <array>
#include <stdexcept>

namespace varimarch
{

namespace
{

using Code = DSRCodedEntryValue;
using Tree = DSRDocumentTree;

// DCMTK's reason, as an error about a file.
void Require(const OFCondition& condition, const std::string& path)
{
  if (condition.bad())
  {
    throw std::runtime_error(path + ": cannot write the measurements as DICOM: " +
      condition.text() + "; save them as CSV instead");
  }
}

/// Writes the content of a report: items are added as the last children of the current one.
class Content
{
public:
  Content(Tree& tree, const std::string& path)
    : tree(tree)
    , path(path)
  {
  }

  const std::string& Path() const { return this->path; }

  /// Adds an item below the current one, and moves there.
  DSRContentItem& Enter(
    DSRTypes::E_RelationshipType relation, DSRTypes::E_ValueType type, const Code& name)
  {
    if (this->tree.addContentItem(relation, type, DSRTypes::AM_belowCurrent) == 0)
    {
      throw std::runtime_error(
        this->path + ": DCMTK cannot write an item of this kind; save the measurements as CSV");
    }
    DSRContentItem& item = this->tree.getCurrentContentItem();
    if (name.isValid())
    {
      Require(item.setConceptName(name), this->path);
    }
    return item;
  }

  void Leave() { this->tree.goUp(); }

  void AddText(DSRTypes::E_RelationshipType relation, const Code& name, const std::string& text)
  {
    Require(
      this->Enter(relation, DSRTypes::VT_Text, name).setStringValue(text.c_str()), this->path);
    this->Leave();
  }

  void AddCode(DSRTypes::E_RelationshipType relation, const Code& name, const Code& value)
  {
    Require(this->Enter(relation, DSRTypes::VT_Code, name).setCodeValue(value), this->path);
    this->Leave();
  }

  void AddUid(DSRTypes::E_RelationshipType relation, const Code& name, const OFString& uid)
  {
    Require(this->Enter(relation, DSRTypes::VT_UIDRef, name).setStringValue(uid), this->path);
    this->Leave();
  }

private:
  Tree& tree;
  const std::string& path;
};

OFString NewUid()
{
  std::array<char, 100> uid;
  return dcmGenerateUniqueIdentifier(uid.data());
}

/// A unit of values and what is measured in it.
struct ValueCodes
{
  Code quantity;
  Code unit;
};

// Values without a known unit are named by a code of ours.
ValueCodes CodesOf(const LoadedVolume& volume)
{
  const std::string unit = UnitOf(volume);
  if (unit == "HU")
  {
    return { Code("112031", "DCM", "Attenuation Coefficient"),
      Code("[hnsf'U]", "UCUM", "Hounsfield unit") };
  }
  if (unit == "SUV")
  {
    return { Code("126401", "DCM", "SUVbw"),
      Code("{SUVbw}g/ml", "UCUM", "Standardized Uptake Value body weight") };
  }
  return { Code("VALUE", "99VARIMARCH", "Value of the voxels"), Code("1", "UCUM", "no units") };
}

/// A number of a measurement.
struct Number
{
  Code quantity;
  Code unit;
  double value;
  Code derivation = {}; ///< the statistic; invalid for a plain number
};

std::vector<Number> NumbersOf(const MeasureValues& values, const ValueCodes& ofValues)
{
  std::vector<Number> numbers;
  const auto add = [&](const std::optional<double>& value, const Code& quantity, const Code& unit)
  {
    if (value)
    {
      numbers.push_back({ quantity, unit, *value });
    }
  };
  add(values.lengthMm, Code("410668003", "SCT", "Length"), Code("mm", "UCUM", "millimeter"));
  add(values.degrees, Code("1483009", "SCT", "Angle"), Code("deg", "UCUM", "degree"));
  add(values.areaMm2, Code("42798000", "SCT", "Area"), Code("mm2", "UCUM", "square millimeter"));
  add(
    values.volumeMm3, Code("118565006", "SCT", "Volume"), Code("mm3", "UCUM", "cubic millimeter"));
  if (values.statistics && values.statistics->voxels > 0)
  {
    const RegionStatistics& found = *values.statistics;
    const auto statistic = [&](const Code& derivation, double value) {
      numbers.push_back({ ofValues.quantity, ofValues.unit, value, derivation });
    };
    statistic(Code("373098007", "SCT", "Mean"), found.mean);
    statistic(Code("386136009", "SCT", "Standard Deviation"), found.standardDeviation);
    statistic(Code("255605001", "SCT", "Minimum"), found.smallest);
    statistic(Code("56851009", "SCT", "Maximum"), found.largest);
  }
  return numbers;
}

void AddNumber(const Number& number, Content& content)
{
  DSRContentItem& item = content.Enter(DSRTypes::RT_contains, DSRTypes::VT_Num, number.quantity);
  Require(item.setNumericValue(DSRNumericMeasurementValue(Decimal(number.value), number.unit)),
    content.Path());
  if (number.derivation.isValid())
  {
    content.AddCode(
      DSRTypes::RT_hasConceptMod, Code("121401", "DCM", "Derivation"), number.derivation);
  }
  content.Leave();
}

void AddLine(
  const std::vector<glm::dvec3>& line, const std::string& frameOfReference, Content& content)
{
  DSRSpatialCoordinates3DValue place(
    line.size() == 1 ? DSRTypes::GT3_Point : DSRTypes::GT3_Polyline);
  for (const glm::dvec3& point : line)
  {
    place.getGraphicDataList().addItem(Float32(point.x), Float32(point.y), Float32(point.z));
  }
  Require(place.setFrameOfReferenceUID(frameOfReference.c_str()), content.Path());
  DSRContentItem& item = content.Enter(
    DSRTypes::RT_contains, DSRTypes::VT_SCoord3D, Code("111030", "DCM", "Image Region"));
  Require(item.setSpatialCoordinates3D(place), content.Path());
  content.Leave();
}

void AddGroup(const Measure& measure, int number, const LoadedVolume& volume, Content& content)
{
  const MeasureTraits& traits = TraitsOf(measure.kind);
  content.Enter(
    DSRTypes::RT_contains, DSRTypes::VT_Container, Code("125007", "DCM", "Measurement Group"));
  content.AddText(DSRTypes::RT_hasObsContext, Code("112039", "DCM", "Tracking Identifier"),
    std::to_string(number) + " " + traits.name);
  content.AddUid(
    DSRTypes::RT_hasObsContext, Code("112040", "DCM", "Tracking Unique Identifier"), NewUid());
  if (!measure.name.empty())
  {
    content.AddText(DSRTypes::RT_contains, Code("121106", "DCM", "Comment"), measure.name);
  }
  MeasureLines lines = LinesOf(measure, volume.image);
  if (lines.empty())
  {
    lines.push_back({ MiddleOf(measure) });
  }
  for (const auto& line : lines)
  {
    AddLine(line, volume.frameOfReference, content);
  }
  for (const Number& one :
    NumbersOf(InUnits(ValuesOf(measure, volume.image), volume), CodesOf(volume)))
  {
    AddNumber(one, content);
  }
  content.Leave();
}

// Language, observer and procedure, which the template requires.
void AddContext(Content& content)
{
  content.AddCode(DSRTypes::RT_hasConceptMod,
    Code("121049", "DCM", "Language of Content Item and Descendants"),
    Code("en", "RFC5646", "English"));
  content.AddCode(DSRTypes::RT_hasObsContext, Code("121005", "DCM", "Observer Type"),
    Code("121007", "DCM", "Device"));
  content.AddUid(
    DSRTypes::RT_hasObsContext, Code("121012", "DCM", "Device Observer UID"), NewUid());
  content.AddText(
    DSRTypes::RT_hasObsContext, Code("121013", "DCM", "Device Observer Name"), "Varimarch");
  content.AddCode(DSRTypes::RT_hasConceptMod, Code("121058", "DCM", "Procedure reported"),
    Code("363679005", "SCT", "Imaging procedure"));
}

// The images of the scan, in the content and among its evidence.
void AddImages(const std::vector<std::string>& images, DSRDocument& document, Content& content)
{
  content.Enter(
    DSRTypes::RT_contains, DSRTypes::VT_Container, Code("111028", "DCM", "Image Library"));
  content.Enter(
    DSRTypes::RT_contains, DSRTypes::VT_Container, Code("126200", "DCM", "Image Library Group"));
  for (const std::string& image : images)
  {
    DcmFileFormat file = ImageOfScan(image);
    DcmDataset& scan = *file.getDataset();
    const ImageUids uids = UidsOf(scan);
    Require(document.getCurrentRequestedProcedureEvidence().addItem(scan), content.Path());
    Require(content.Enter(DSRTypes::RT_contains, DSRTypes::VT_Image, Code())
              .setImageReference(DSRImageReferenceValue(uids.ofClass, uids.ofInstance)),
      content.Path());
    content.Leave();
  }
  content.Leave();
  content.Leave();
}

// A new document of the scan's patient and study.
void AddScan(const std::string& image, DSRDocument& document, const std::string& path)
{
  DcmFileFormat file = ImageOfScan(image);
  DcmDataset& scan = *file.getDataset();
  ConvertTextsToUtf8(scan, image); // as the names of the measurements are
  Require(document.setSpecificCharacterSetType(DSRTypes::CS_UTF8), path);
  Require(document.readPatientData(scan), path);
  Require(document.readStudyData(scan), path);
  Require(document.setSeriesDescription("Measurements"), path);
  Require(document.setManufacturer("Varimarch"), path);
  Require(document.setManufacturerModelName("varimarch-viewer"), path);
  Require(document.setDeviceSerialNumber("1"), path);
  Require(document.setSoftwareVersions("1"), path);
}

}

void WriteDicomMeasures(const std::vector<Measure>& measures, const LoadedVolume& volume,
  const std::vector<std::string>& images, const std::string& path)
{
  RequireNoImage(images, path);
  if (volume.frameOfReference.empty())
  {
    throw std::runtime_error(path +
      ": expected a scan whose files name their frame of reference, in which points are measured, "
      "found none; save the measurements as CSV instead");
  }
  // DCMTK would print about each attribute that an old scanner left out.
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  DSRDocument document(DSRTypes::DT_Comprehensive3DSR);
  AddScan(images.front(), document, path);
  Tree& tree = document.getTree();
  tree.addContentItem(DSRTypes::RT_isRoot, DSRTypes::VT_Container);
  DSRContentItem& root = tree.getCurrentContentItem();
  Require(root.setConceptName(Code("126000", "DCM", "Imaging Measurement Report")), path);
  Require(root.setTemplateIdentification("1500", "DCMR"), path);
  Content content(tree, path);
  AddContext(content);
  AddImages(images, document, content);
  content.Enter(
    DSRTypes::RT_contains, DSRTypes::VT_Container, Code("126010", "DCM", "Imaging Measurements"));
  for (std::size_t i = 0; i < measures.size(); ++i)
  {
    AddGroup(measures[i], int(i) + 1, volume, content);
  }
  DcmFileFormat file;
  Require(document.write(*file.getDataset()), path);
  WriteFileWhole(path,
    [&](const std::string& part)
    {
      Require(file.saveFile(part.c_str(), EXS_LittleEndianExplicit), path);
      return true;
    });
}

}
