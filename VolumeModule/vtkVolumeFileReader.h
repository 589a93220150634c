/**
 * @class   vtkVolumeFileReader
 * @brief   Reads a volume of any supported format, in patient coordinates
 *
 * One reader for VTI, NRRD, MetaImage, NIfTI, DICOM, InVesalius projects, TIFF, NumPy, MGH, MINC,
 * AFNI, MIF, PAR/REC, GIPL, MRC, SLC, PVM, OME-Zarr, HDF5, stacks of pictures and raw voxels. Set a
 * file name (for DICOM: a folder, a DICOMDIR or a file; for a stack of pictures: a folder) and
 * update:
 * @code
 *   vtkNew<vtkVolumeFileReader> reader;
 *   reader->SetFileName("head.nrrd");
 *   reader->Update();
 *   if (reader->GetErrorCode()) { std::cerr << reader->GetErrorMessage() << "\n"; }
 * @endcode
 *
 * The output is in DICOM's LPS space (x to the patient's left, y to the back, z to the head), in
 * mm, described by its origin, its spacing (> 0) and its direction matrix, which may mirror or
 * shear. Voxels keep the order of the file: nothing is flipped, and only RectifySlices resamples.
 * Extents begin at 0. Stored values are rescaled to physical ones, such as Hounsfield units for CT.
 * One of several times is read, see SetTimeIndex().
 *
 * If a file cannot be read, the output is empty, GetErrorCode() is not 0, and one error event is
 * invoked whose message, one sentence, is also in GetErrorMessage(): the file, what was expected,
 * what was found. Sizes are checked against the file and the machine's memory before memory is
 * allocated.
 *
 * Libraries that others maintain parse DICOM, VTI, TIFF, pictures, MINC, OME-Zarr, HDF5, InVesalius
 * projects and archives in a process of its own, the program varimarch-decode, with limits of
 * memory and time. A file at which it crashes or hangs is an error like any other; the other slices
 * of a series are read. Without that program these formats cannot be read.
 *
 * The file is read in UpdateInformation(), because the type of rescaled values is known only after
 * that. Progress events are invoked there. SetAbortExecute(1) in an observer stops the reader: the
 * output is empty, the error code is vtkErrorCode::UserError, and there is no error event.
 *
 * @sa vtkDICOMReader
 */

#ifndef vtkVolumeFileReader_h
#define vtkVolumeFileReader_h

#include "VarimarchVolumeModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <functional> // For Try
#include <memory>     // For Read
#include <string>     // For DICOMSeriesUID and ErrorMessage
#include <vector>     // For ListDICOMSeries

class vtkStringArray;

namespace varimarch
{
class ReadProgress;
struct KeptInput;
}

class VARIMARCHVOLUME_EXPORT vtkVolumeFileReader : public vtkImageAlgorithm
{
public:
  static vtkVolumeFileReader* New();
  vtkTypeMacro(vtkVolumeFileReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file, or the folder of DICOM files, to read.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * The layout of a file of raw voxels (.raw). The dimensions are required; if they are set, a file
   * of unknown format is also read as raw voxels. Defaults: dimensions 0 (unset), type
   * VTK_UNSIGNED_CHAR, 1 component, spacing 1 mm, header of 0 bytes, little endian.
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
   * Memory that the program may use [bytes]; 0, the default: all of the machine's. Voxels that need
   * more than a quarter of it stay in their file, if that has them as they are in memory:
   * uncompressed single numbers of 8 bits, 16 bits or type float, in this machine's byte order, in
   * one NRRD, MetaImage, NIfTI or raw file. The scalars are then a mapping of the file, whose pages
   * the system reads when they are touched, and drops again before the program has more than this
   * memory. A level of OME-Zarr or HDF5 that needs more than half of the memory stays in its chunks
   * in the same way, where the system has userfaultfd. Other voxels are refused if they need more.
   * A program that changes such scalars changes its own copy of their pages only.
   */
  vtkSetClampMacro(MaximumHostMemory, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(MaximumHostMemory, vtkIdType);
  ///@}

  /**
   * True after Update() if the voxels stayed in their file or its chunks.
   */
  bool HasVoxelsOnDisk();

  ///@{
  /**
   * Allow a preview: voxels that stay in their file are read once from end to end when it is first
   * opened, which takes minutes for large files. A coarse copy is read instead, of some of the
   * voxels or of a coarse level of the file, if there is one, and a warning says so. Nothing is
   * promised about the error of its images. IsPreview() is true after Update() if the output is
   * such a copy. Default: false.
   */
  vtkSetMacro(PreviewAllowed, bool);
  vtkGetMacro(PreviewAllowed, bool);
  vtkBooleanMacro(PreviewAllowed, bool);
  bool IsPreview();
  ///@}

  ///@{
  /**
   * The DICOM series to read if there are several: its SeriesInstanceUID, an unambiguous prefix of
   * that, or its number in ListDICOMSeries(), counted from 1. Default: empty, the first series; the
   * warnings then list all.
   */
  vtkSetStdStringFromCharMacro(DICOMSeriesUID);
  vtkGetCharFromStdStringMacro(DICOMSeriesUID);
  ///@}

  ///@{
  /**
   * The kind of volume to read of a DICOM series that holds several, counted from 1: images of
   * another echo, b-value, view, direction or station, which are no times of one volume.
   * GetDICOMKindName() are what tells each from the others, such as "echo 20", after Update().
   * Default: 0, the first; the warnings then list all.
   */
  vtkSetClampMacro(DICOMKind, int, 0, VTK_INT_MAX);
  vtkGetMacro(DICOMKind, int);
  int GetNumberOfDICOMKinds();
  const char* GetDICOMKindName(int kind);
  ///@}

  ///@{
  /**
   * Resample a DICOM series to an even, orthogonal grid if its gantry was tilted, or if its slices
   * are unevenly spaced or missing. Otherwise the output keeps the shear of a tilt in its direction
   * matrix, and its slices are placed at even distances. A regular series is never resampled.
   * Default: false.
   */
  vtkSetMacro(RectifySlices, bool);
  vtkGetMacro(RectifySlices, bool);
  vtkBooleanMacro(RectifySlices, bool);
  ///@}

  ///@{
  /**
   * Resample a DICOM series as RectifySlices does, but only if its slices would not be placed where
   * they were scanned, and if no gap is wider than four usual distances, so that little is made up.
   * Slices of a tilted gantry keep their places without that. Default: false.
   */
  vtkSetMacro(RectifyMisplacedSlices, bool);
  vtkGetMacro(RectifyMisplacedSlices, bool);
  vtkBooleanMacro(RectifyMisplacedSlices, bool);
  ///@}

  ///@{
  /**
   * The level to read of OME-Zarr, Imaris or BigDataViewer, the finest of which is 0. Default: -1,
   * the finest that fits in half of the memory that is free or stays in its chunks, see
   * SetMaximumHostMemory(); the warnings name it if it is not 0.
   */
  vtkSetClampMacro(ResolutionLevel, int, -1, VTK_INT_MAX);
  vtkGetMacro(ResolutionLevel, int);
  ///@}

  ///@{
  /**
   * The channel to read of these formats, or the setup of BigDataViewer, counted from 0. -1 reads
   * all channels of a file with two to four as components of the voxels, if they fit in half of the
   * memory that is free, and otherwise the first. Default: 0.
   */
  vtkSetClampMacro(Channel, int, -1, VTK_INT_MAX);
  vtkGetMacro(Channel, int);
  ///@}

  ///@{
  /**
   * The time to read unless the pipeline requests one, counted from 0. The file's times are the
   * TIME_STEPS of the pipeline, in seconds if HasTimesInSeconds(), else these numbers. A request
   * (UPDATE_TIME_STEP, UpdateTimeStep()) reads the time nearest to it. Only one time is in memory.
   * Reading the times in their order unpacks a file only once. Default: 0.
   */
  void SetTimeIndex(int index);
  vtkGetMacro(TimeIndex, int);
  ///@}

  ///@{
  /**
   * Take files as times: the volumes in a folder, without its subfolders, or those beside a file
   * whose names differ from its own only in the last number before the first dot, such as
   * scan_001.nii.gz. Their order is that of the numbers, and their sizes must be equal. Default:
   * false.
   */
  vtkSetMacro(FilesAreTimes, bool);
  vtkGetMacro(FilesAreTimes, bool);
  vtkBooleanMacro(FilesAreTimes, bool);
  ///@}

  ///@{
  /**
   * The longest time that decoding a file may take without progress [s], > 0. Each MB of a DICOM
   * file's decoded pixels adds a second, since one of many frames is decoded in one step. Default:
   * 60.
   */
  vtkSetClampMacro(LongestSilence, double, 0.01, VTK_DOUBLE_MAX);
  vtkGetMacro(LongestSilence, double);
  ///@}

  /**
   * A DICOM series: one scan of a patient.
   */
  struct DICOMSeries
  {
    std::string UID;
    std::string Description; ///< text that the operator of the scanner entered, or empty
    std::string Modality;
    vtkTypeInt64 NumberOfImages;
    std::string MiddleFile;          ///< the file with the middle image of the series
    std::string FrameOfReferenceUID; ///< see GetFrameOfReferenceUID(); may be empty
  };

  /**
   * Lists the DICOM series at FileName (a folder including its subfolders, a DICOMDIR, or a file),
   * those with most images first; or in an archive, whose files are unpacked for as long as this
   * reader lives and reads nothing else. The list is empty for volumes of other formats. Reads
   * headers only. Reports errors as Update() does, and then returns an empty list.
   */
  std::vector<DICOMSeries> ListDICOMSeries();

  ///@{
  /**
   * Metadata of the volume, valid after Update(). Nothing of it identifies a patient.
   */
  /// "CT", "MR", another DICOM modality, or empty.
  const char* GetModality();
  /// The body part that was examined, in DICOM's terms such as "HEAD"; or empty.
  const char* GetBodyPart();
  bool HasContrastAgent();
  /// Weighting of an MR image, derived from its timing: "T1", "T2", "angiography", or empty.
  const char* GetWeighting();
  /// True if the file recommends a range of values to show; GetWindow() is its width, GetLevel()
  /// its centre.
  bool HasWindowLevel();
  double GetWindow();
  double GetLevel();
  /// True if slices are meant with their smallest values white, as in DICOM images with
  /// MONOCHROME1.
  bool IsInverted();
  /// True if the gantry was tilted, or slices are unevenly spaced or missing: RectifySlices then
  /// changes the volume.
  bool HasIrregularSlices();
  /// True if the slices have been resampled.
  bool HasRectifiedSlices();
  /// Factor from the values of PET to standardized uptake values by body weight [g/ml]; 0 if the
  /// file does not say all that this needs.
  double GetUptakeValueFactor();
  /// Times of the file, in ascending order, at least one; the output is one of them.
  int GetNumberOfTimes();
  double GetTimeValue(int time);
  bool HasTimesInSeconds();
  /// Number of the time that was read, counted from 0.
  int GetReadTime();
  /// UID of the space that the positions are in, the same for scans that fit on each other; or
  /// empty.
  const char* GetFrameOfReferenceUID();
  /// Sentences about doubtful input, such as missing slices. Owned by the reader.
  vtkStringArray* GetWarnings();
  ///@}

  /**
   * A segment of a label map, such as an organ: the voxels of one value.
   */
  struct Segment
  {
    int Value;        ///< not 0, which means no segment
    std::string Name; ///< may be empty
    bool HasColor;
    double Color[3]; ///< red, green and blue, [0, 1]; only if HasColor
  };

  ///@{
  /**
   * True after Update() if the file says that its values are labels, as DICOM segmentations,
   * 3D Slicer's .seg.nrrd and NIfTI label maps do. GetSegments() are those that it describes;
   * values may occur that have no description.
   */
  bool HoldsLabels();
  std::vector<Segment> GetSegments();
  ///@}

  /**
   * The sentence that describes the last error; empty after success.
   */
  const char* GetErrorMessage();

  ///@{
  /**
   * The supported formats, for file dialogs: name, description, and extensions such as ".nrrd
   * .nhdr". Requires 0 <= format < GetNumberOfFormats(); otherwise the results are null or empty.
   */
  static int GetNumberOfFormats();
  static const char* GetFormatName(int format);
  static const char* GetFormatDescription(int format);
  static std::string GetFormatExtensions(int format);
  ///@}

  /**
   * The name of the format of a file or folder, found as CanReadFile() does; null if there is none.
   */
  static const char* GetFormatOfFile(const char* path);

  /**
   * True if a file exists and begins as a file of a known format does or, for formats without a
   * signature, has one of their extensions; also true for every folder, since it may hold DICOM
   * files. Reads at most 4096 bytes.
   */
  static bool CanReadFile(const char* path);

  vtkMTimeType GetMTime() override;

protected:
  vtkVolumeFileReader();
  ~vtkVolumeFileReader() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  struct Contents;

  /// Runs an action on the file; reports an exception that it throws as this reader's error.
  void Try(const std::function<void(varimarch::ReadProgress&)>& action);
  /// Sets and reports an error of the file.
  void Fail(const std::string& sentence);
  /// Postcondition: either Read holds an image, or the error is set and reported.
  void ReadFile(int time);
  void ReadFileOrThrow(int time, varimarch::ReadProgress& progress);
  /// The time that the pipeline requests, or else TimeIndex.
  int RequestedTime(vtkInformation* output);

  char* FileName = nullptr;
  int RawDimensions[3] = { 0, 0, 0 };
  int RawScalarType = VTK_UNSIGNED_CHAR;
  int RawNumberOfComponents = 1;
  double RawSpacing[3] = { 1.0, 1.0, 1.0 };
  vtkTypeInt64 RawHeaderBytes = 0;
  bool RawBigEndian = false;
  std::string DICOMSeriesUID;
  int DICOMKind = 0;
  bool RectifySlices = false;
  bool RectifyMisplacedSlices = false;
  int ResolutionLevel = -1;
  int Channel = 0;
  int TimeIndex = 0;
  vtkTimeStamp TimeIndexChange; ///< apart from the other settings, which change what is kept
  bool FilesAreTimes = false;
  double LongestSilence = 60.0;
  vtkIdType MaximumHostMemory = 0;
  bool PreviewAllowed = false;

  std::unique_ptr<Contents> Read;
  std::unique_ptr<varimarch::KeptInput> Kept; ///< memory from one time to the next
  vtkMTimeType KeptMTime = 0;                 ///< the settings that Kept belongs to
  std::string ErrorMessage;

  vtkVolumeFileReader(const vtkVolumeFileReader&) = delete;
  void operator=(const vtkVolumeFileReader&) = delete;
};

#endif
