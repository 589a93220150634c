#include "Readers/Dicom/Metadata.h"

#include "Readers/Dicom/Attributes.h"
#include "Readers/Dicom/DicomFrame.h"
#include "Readers/Dicom/FileHeader.h"
#include "Readers/FileError.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Parsing/VtkMessages.h"
#include "Readers/Parsing/VtkProgress.h"

#include <vtkDICOMDataElement.h>
#include <vtkDICOMDictEntry.h>
#include <vtkDICOMDictHash.h>
#include <vtkDICOMDirectory.h>
#include <vtkDICOMItem.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>

namespace varimarch
{
namespace
{

/// The standardized uptake values (SUV) of an image.
struct UptakeValue
{
  std::optional<double> factor; ///< from values to SUV by body weight [g/ml]
  std::string doubt; ///< the reason why a PET image has no factor, as the end of a sentence
};

constexpr double SecondsPerDay = 86400.0;

const vtkDICOMTag PhilipsSuvFactor(0x7053, 0x1000);

// Numbers beyond these are in another unit, or have been changed by a program that removes names:
// after 12 half-lives a tracer is hardly measurable.
constexpr double MostHalfLives = 12.0;
constexpr double LeastDoseBq = 1e5;
constexpr double MostDoseBq = 1e11;
constexpr double MostWeightKg = 700.0;

/// Thrown with the reason why there is no factor.
struct Doubt
{
  std::string reason;
};

void Require(bool isTrue, const std::string& otherwise)
{
  if (!isTrue)
  {
    throw Doubt{ otherwise };
  }
}

vtkDICOMTagPath OfTracer(vtkDICOMTag tag)
{
  return { DC::RadiopharmaceuticalInformationSequence, 0, tag };
}

/// The start of the scan, in the local time of the file [s].
double StartOfScan(const DicomAttributes& attributes)
{
  const auto scan =
    SecondsOfMoment(attributes.Text(DC::SeriesDate), attributes.Text(DC::SeriesTime));
  const auto acquired =
    SecondsOfMoment(attributes.Text(DC::AcquisitionDate), attributes.Text(DC::AcquisitionTime));
  Require(scan && acquired, "the file does not say when the scan began");
  Require(*scan <= *acquired, "the series is younger than its images, so it was computed later");
  return *scan;
}

/// The moment of the injection as the file states it with its date, in the local time of the file.
/// Empty if it does not, or in a time zone while that of the file is unknown.
std::optional<double> DatedInjection(const DicomAttributes& attributes)
{
  const std::string whole = attributes.Text(OfTracer(DC::RadiopharmaceuticalStartDateTime));
  const auto moment =
    whole.size() > 8 ? SecondsOfMoment(whole.substr(0, 8), whole.substr(8)) : std::nullopt;
  const auto zone = SecondsOfZone(whole);
  if (!moment || !zone)
  {
    return moment;
  }
  const auto zoneOfFile = SecondsOfZone(attributes.Text(DC::TimezoneOffsetFromUTC));
  return zoneOfFile ? std::optional(*moment - *zone + *zoneOfFile) : std::nullopt;
}

/// The time from the injection to the start of the scan [s].
double DecaySeconds(const DicomAttributes& attributes)
{
  const double scan = StartOfScan(attributes);
  const auto dated = DatedInjection(attributes);
  const auto injected = dated ? dated
                              : SecondsOfMoment(attributes.Text(DC::SeriesDate),
                                  attributes.Text(OfTracer(DC::RadiopharmaceuticalStartTime)));
  Require(injected.has_value(), "the file does not say when the tracer was injected");
  // A time without a date may be that of the day before.
  const double elapsed = scan - *injected + (!dated && *injected > scan ? SecondsPerDay : 0.0);
  Require(elapsed >= 0.0, "the tracer was injected after the scan had begun");
  return elapsed;
}

/// The dose to which the values refer [Bq].
double ReferenceDose(const DicomAttributes& attributes)
{
  const double dose = attributes.Number(OfTracer(DC::RadionuclideTotalDose)).value_or(0.0);
  const std::string correction = attributes.Text(DC::DecayCorrection);
  Require(dose > 0.0, "the file does not say the dose");
  Require(dose >= LeastDoseBq && dose <= MostDoseBq,
    "a dose of " + ShortText(dose) + " Bq cannot be true");
  Require(correction == "START" || correction == "ADMIN",
    "the file does not say to which moment its values are corrected");
  if (correction == "ADMIN")
  {
    return dose;
  }
  const double halfLife = attributes.Number(OfTracer(DC::RadionuclideHalfLife)).value_or(0.0);
  Require(halfLife > 0.0, "the file does not say the half-life of the tracer");
  const double halfLives = DecaySeconds(attributes) / halfLife;
  Require(halfLives <= MostHalfLives,
    "the tracer was injected " + ShortText(halfLives) +
      " half-lives before the scan, which cannot be true");
  return dose * std::exp2(-halfLives);
}

double WeightKg(const DicomAttributes& attributes)
{
  const double weightKg = attributes.NumberOr(DC::PatientWeight, 0.0);
  Require(weightKg > 0.0, "the file does not say the weight of the patient");
  Require(weightKg <= MostWeightKg, "a weight of " + ShortText(weightKg) + " kg cannot be true");
  return weightKg;
}

double FactorOf(const DicomAttributes& attributes)
{
  constexpr double GramsPerKg = 1000.0;
  const std::string units = attributes.Text(DC::Units);
  if (units == "GML")
  {
    const std::string type = attributes.Text(DC::SUVType);
    Require(
      type.empty() || type == "BW", "its values are not by body weight, but by " + Quoted(type));
    return 1.0;
  }
  const std::string corrections = attributes.Text(DC::CorrectedImage);
  Require(
    corrections.find("ATTN") != std::string::npos && corrections.find("DECY") != std::string::npos,
    "its values are not corrected for attenuation and decay");
  if (units == "CNTS")
  {
    const double factor = attributes.NumberOr(PhilipsSuvFactor, 0.0);
    Require(factor > 0.0, "its values are counts without a factor");
    return factor;
  }
  Require(units == "BQML",
    units.empty() ? "the file does not say the unit of its values"
                  : "its values are in the unit " + Quoted(units));
  return GramsPerKg * WeightKg(attributes) / ReferenceDose(attributes);
}

/// Determines the factor to standardized uptake values of a PET image as QIBA's profile for FDG
/// computes it (QIBA, "SUV vendor-neutral pseudo-code", 2012): values in Bq/ml times the patient's
/// weight, divided by the dose that was left at the start of the scan. Values that are SUV by body
/// weight already have the factor 1, and those of Philips' counts the factor that the file gives.
/// There is no factor where the file does not say what is needed, or what it says cannot be true.
/// Both members are empty for other modalities.
UptakeValue UptakeValueOf(const DicomAttributes& attributes)
{
  if (attributes.Text(DC::Modality) != "PT")
  {
    return {};
  }
  try
  {
    return { FactorOf(attributes), "" };
  }
  catch (const Doubt& doubt)
  {
    return { std::nullopt, doubt.reason };
  }
}

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

DicomRecord RecordOf(const std::string& path)
{
  const DicomHeader header = ReadDicomHeader(path);
  DicomRecord record;
  if (!header.file)
  {
    return record;
  }
  const DicomAttributes attributes(header.meta);
  const auto text = [&](const vtkDICOMTag& tag) { return attributes.Value(tag).AsUTF8String(); };
  record.patientName = text(DC::PatientName);
  record.patientId = text(DC::PatientID);
  record.studyUid = text(DC::StudyInstanceUID);
  record.studyDate = text(DC::StudyDate);
  record.studyDescription = text(DC::StudyDescription);
  record.seriesUid = header.file->seriesUid;
  record.seriesNumber = int(std::clamp(header.file->seriesNumber, -1e9, 1e9));
  record.seriesDescription = header.file->seriesDescription;
  record.modality = header.file->modality;
  record.imageUid = header.file->instanceUid;
  return record;
}

namespace
{

/// The deepest sequences that are listed. No standard object has more than about ten.
constexpr int MostDepth = 32;

/// The most bytes of a text.
constexpr std::size_t MostTextBytes = 10000;

/// The most bytes of a binary value that are written out.
constexpr unsigned int MostBinaryBytes = 64;

std::string TextOfTag(const vtkDICOMTag& tag)
{
  char text[12];
  std::snprintf(text, sizeof text, "(%04x,%04x)", tag.GetGroup(), tag.GetElement());
  return text;
}

bool IsControl(char letter)
{
  return std::uint8_t(letter) < 0x20 || letter == 0x7f;
}

/// A text that is not cut within a letter of UTF-8.
std::string Cut(std::string text)
{
  std::replace_if(text.begin(), text.end(), IsControl, ' ');
  if (text.size() <= MostTextBytes)
  {
    return text;
  }
  std::size_t end = MostTextBytes;
  while (end > 0 && (std::uint8_t(text[end]) & 0xc0) == 0x80)
  {
    --end;
  }
  return text.substr(0, end) + "...";
}

/// A binary value. Private attributes often hold texts whose representation got lost.
std::string BinaryText(const vtkDICOMValue& value)
{
  const unsigned char* const bytes = value.GetUnsignedCharData();
  const unsigned int count = bytes ? value.GetVL() : 0;
  const auto isPrintable = [](unsigned char byte) { return byte >= 0x20 && byte < 0x7f; };
  const unsigned int letters = count > 0 && bytes[count - 1] == 0 ? count - 1 : count;
  if (letters > 0 && std::all_of(bytes, bytes + letters, isPrintable))
  {
    return Cut(std::string(bytes, bytes + letters));
  }
  if (!bytes || count > MostBinaryBytes)
  {
    return value.GetVL() == 0 ? "" : std::to_string(value.GetVL()) + " bytes";
  }
  std::string text;
  for (unsigned int i = 0; i < count; ++i)
  {
    char digits[4];
    std::snprintf(digits, sizeof digits, i == 0 ? "%02x" : " %02x", bytes[i]);
    text += digits;
  }
  return text;
}

std::string ValueText(const vtkDICOMValue& value)
{
  // The representations of bytes and of words are OB, OD, OF, OL, OV and OW.
  const std::string representation = value.GetVR().GetText();
  const bool isBinary = representation == "UN" || representation[0] == 'O';
  return isBinary ? BinaryText(value) : Cut(value.AsUTF8String());
}

/// Appends the attributes of a file, or of an item of a sequence.
template <class Attributes>
void Append(Attributes& attributes, int depth, std::vector<DicomTag>& tags)
{
  for (auto element = attributes.Begin(); element != attributes.End(); ++element)
  {
    const vtkDICOMTag tag = element->GetTag();
    const vtkDICOMDictEntry entry = attributes.FindDictEntry(tag);
    const vtkDICOMValue& value = element->GetValue();
    const vtkDICOMItem* const items = value.GetSequenceData();
    tags.push_back({ depth, TextOfTag(tag), value.GetVR().GetText(),
      entry.IsValid() ? entry.GetName() : "", items ? "" : ValueText(value) });
    for (std::size_t i = 0; items && depth < MostDepth && i < value.GetNumberOfValues(); ++i)
    {
      tags.push_back({ depth + 1, "", "", "Item " + std::to_string(i + 1), "" });
      Append(items[i], depth + 2, tags);
    }
  }
}

}

std::vector<DicomTag> TagsOf(const std::string& path)
{
  const DicomHeader header = ReadDicomHeader(path);
  if (!header.meta)
  {
    FailToRead(
      path, "a DICOM file", header.fault ? header.fault->found : "a file of another format");
  }
  std::vector<DicomTag> tags;
  Append(*header.meta, 0, tags);
  return tags;
}

std::vector<std::string> FilesOfIndex(const std::string& index, ReadProgress& progress)
{
  VtkMessages silenced;
  vtkNew<vtkDICOMDirectory> directory;
  silenced.Observe(directory);
  const auto folder = std::filesystem::path(index).parent_path();
  directory->SetDirectoryName(folder.empty() ? "." : folder.c_str());
  UpdateWithProgress(directory, progress);
  std::vector<std::string> files;
  for (int series = 0; series < directory->GetNumberOfSeries(); ++series)
  {
    vtkStringArray* const names = directory->GetFileNamesForSeries(series);
    for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
    {
      files.push_back(names->GetValue(i));
    }
  }
  return files;
}

}
