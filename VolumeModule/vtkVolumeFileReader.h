/**
 * @class   vtkVolumeFileReader
 * @brief   Opens a volume of any supported format, placed right in the patient
 *
 * One entry point for VTI, NRRD, MetaImage, NIfTI, DICOM, InVesalius projects and bare voxels. Set
 * a file name (for DICOM: a folder, a DICOMDIR or a file) and update:
 * @code
 *   vtkNew<vtkVolumeFileReader> reader;
 *   reader->SetFileName("head.nrrd");
 *   reader->Update();
 *   if (reader->GetErrorCode()) { std::cerr << reader->GetErrorMessage() << "\n"; }
 * @endcode
 *
 * The output lies in DICOM's LPS space (x to the patient's left, y to the back, z to the head) in
 * mm, by its origin, its spacing (> 0) and its direction matrix, which may be mirrored or sheared.
 * Voxels keep their order in the file: nothing is flipped, and nothing resampled unless
 * RectifySlices asks for it. Extents begin at 0. Stored values are rescaled to what they mean:
 * Hounsfield units for CT.
 *
 * When a file cannot be read, the output is empty, GetErrorCode() is not 0, and one error event
 * carries one sentence, also in GetErrorMessage(): which file, what was expected, what was found.
 * Sizes are checked, against the file and the machine's memory, before memory is taken.
 *
 * The file is read in UpdateInformation(), because the type of rescaled values is known only then.
 * Progress events come from there; SetAbortExecute(1) in an observer stops the reading, and leaves
 * the output empty with the error code vtkErrorCode::UserError but no error event.
 *
 * @sa vtkDICOMReader
 */

#ifndef vtkVolumeFileReader_h
#define vtkVolumeFileReader_h

#include "VarimarchVolumeModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <functional> // For actions on the file
#include <memory>     // For what was read
#include <string>     // For names and messages
#include <vector>     // For lists of series

class vtkStringArray;

namespace varimarch
{
class ReadProgress;
}

class VARIMARCHVOLUME_EXPORT vtkVolumeFileReader : public vtkImageAlgorithm
{
public:
  static vtkVolumeFileReader* New();
  vtkTypeMacro(vtkVolumeFileReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file, or folder of DICOM files, to read.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * What a file of bare voxels (.raw) does not say about itself. The dimensions must be set for
   * one; with them set, a file of unknown kind counts as bare voxels too. Defaults: dimensions 0
   * (unset), type VTK_UNSIGNED_CHAR, 1 component, spacing 1 mm, no header, little endian.
   */
  vtkSetVector3Macro(RawDimensions, int);
  vtkGetVector3Macro(RawDimensions, int);
  vtkSetMacro(RawScalarType, int);
  vtkGetMacro(RawScalarType, int);
  vtkSetMacro(RawNumberOfComponents, int);
  vtkGetMacro(RawNumberOfComponents, int);
  vtkSetVector3Macro(RawSpacing, double);
  vtkGetVector3Macro(RawSpacing, double);
  vtkSetMacro(RawHeaderBytes, vtkTypeInt64);
  vtkGetMacro(RawHeaderBytes, vtkTypeInt64);
  vtkSetMacro(RawBigEndian, bool);
  vtkGetMacro(RawBigEndian, bool);
  vtkBooleanMacro(RawBigEndian, bool);
  ///@}

  ///@{
  /**
   * Which of several DICOM series to read: by its SeriesInstanceUID, by the beginning of just one
   * of them, or by its number in ListDICOMSeries(), from 1. Empty, the default, is the first; the
   * warnings list all then.
   */
  vtkSetStdStringFromCharMacro(DICOMSeriesUID);
  vtkGetCharFromStdStringMacro(DICOMSeriesUID);
  ///@}

  ///@{
  /**
   * Whether a DICOM series whose gantry was tilted, or whose slices lie at uneven distances or are
   * missing, is resampled on an even grid with right angles. A volume as scanned keeps the shear of
   * a tilt in its direction matrix, but has its slices at even distances. A series that is even
   * already stays as it is. Default: false.
   */
  vtkSetMacro(RectifySlices, bool);
  vtkGetMacro(RectifySlices, bool);
  vtkBooleanMacro(RectifySlices, bool);
  ///@}

  /**
   * A DICOM series: one scan of a patient.
   */
  struct DICOMSeries
  {
    std::string UID;
    std::string Description; ///< as the scanner's operator named it, or empty
    std::string Modality;
    vtkTypeInt64 NumberOfImages;
    std::string MiddleFile; ///< that with the image in the middle of the series
  };

  /**
   * Looks which DICOM series there are at FileName: a folder with the folders in it, a DICOMDIR or
   * a file; those with most images first. Reads headers only. Reports errors as Update() does, and
   * returns none then.
   */
  std::vector<DICOMSeries> ListDICOMSeries();

  ///@{
  /**
   * What the file says about the volume. Valid after Update(). Nothing identifies a patient.
   */
  /// "CT", "MR", another DICOM modality, or empty.
  const char* GetModality();
  /// What was imaged, as DICOM has it, such as "HEAD"; or empty.
  const char* GetBodyPart();
  bool HasContrastAgent();
  /// Of MR, by the times of its sequence: "T1", "T2", "angiography", or empty.
  const char* GetWeighting();
  /// Whether the file says how to show the values: the width and the centre of the range to show.
  bool HasWindowLevel();
  double GetWindow();
  double GetLevel();
  /// Whether slices of the scan were tilted, lie at uneven distances or are missing: whether
  /// RectifySlices changes the volume.
  bool HasIrregularSlices();
  /// Sentences about what is doubtful, such as missing slices. Owned by the reader.
  vtkStringArray* GetWarnings();
  ///@}

  /**
   * The sentence of the last error, empty after success.
   */
  const char* GetErrorMessage();

  ///@{
  /**
   * The formats, for file dialogs: a name, a description, and extensions as in ".nrrd .nhdr".
   * 0 <= format < GetNumberOfFormats(); others have no name, no description, no extensions.
   */
  static int GetNumberOfFormats();
  static const char* GetFormatName(int format);
  static const char* GetFormatDescription(int format);
  static std::string GetFormatExtensions(int format);
  ///@}

  /**
   * Whether a file exists, is of a known format by its name or first bytes, and begins as that
   * format does. True for any folder, which may hold DICOM files. Reads 512 bytes at most.
   */
  static bool CanReadFile(const char* path);

protected:
  vtkVolumeFileReader();
  ~vtkVolumeFileReader() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  struct Contents;

  /// Does something with the file; what it throws becomes the error, which is reported.
  void Try(const std::function<void(varimarch::ReadProgress&)>& action);
  /// Afterwards either Read holds an image or the error is set and reported.
  void ReadFile();
  void ReadFileOrThrow(varimarch::ReadProgress& progress);

  char* FileName = nullptr;
  int RawDimensions[3] = { 0, 0, 0 };
  int RawScalarType = VTK_UNSIGNED_CHAR;
  int RawNumberOfComponents = 1;
  double RawSpacing[3] = { 1.0, 1.0, 1.0 };
  vtkTypeInt64 RawHeaderBytes = 0;
  bool RawBigEndian = false;
  std::string DICOMSeriesUID;
  bool RectifySlices = false;

  std::unique_ptr<Contents> Read;
  std::string ErrorMessage;

  vtkVolumeFileReader(const vtkVolumeFileReader&) = delete;
  void operator=(const vtkVolumeFileReader&) = delete;
};

#endif
