// Libraries that others maintain parse files in the program varimarch-decode. Its crash, hang and
// greed end as a sentence, and leave the other slices, no process and no descriptor.
#include "DicomReading.h"
#include "Support/ExpectedVtkErrors.h"

#include "Readers/Decoder/DecoderSession.h"

#include <vtkCallbackCommand.h>
#include <vtkErrorCode.h>

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

using phantom_dicom::Elements;
using std::string_literals::operator""s;

constexpr const char* JpegSyntax = "1.2.840.10008.1.2.4.50";
constexpr const char* Jpeg2000Syntax = "1.2.840.10008.1.2.4.90";
constexpr std::uint32_t PixelData = 0x7fe00010;

/// Another program in place of the decoder, for as long as this object lives.
class OtherDecoder
{
public:
  explicit OtherDecoder(const std::string& program)
  {
    setenv("VARIMARCH_DECODER", program.c_str(), 1);
  }
  ~OtherDecoder() { unsetenv("VARIMARCH_DECODER"); }
};

/// The same slice with one fragment of compressed pixels.
Elements Encapsulated(Elements elements, const std::string& fragment)
{
  const auto number = [](std::uint32_t value)
  { return std::string(reinterpret_cast<const char*>(&value), sizeof(value)); };
  const std::string item = "\xfe\xff\x00\xe0"s;
  elements[PixelData] = { "OB",
    item + number(0) + item + number(std::uint32_t(fragment.size())) + fragment, true };
  return elements;
}

/// An image of JPEG 2000 without any detail, of one component of 16 bits (ISO/IEC 15444-1, annex
/// A).
std::string Jpeg2000Bytes(std::uint32_t size)
{
  const auto big = [](std::uint32_t number) {
    return std::string{ char(number >> 24), char(number >> 16), char(number >> 8), char(number) };
  };
  const std::string start = "\xff\x4f\xff\x51\0\x29\0\0"s;
  const std::string sizes = big(size) + big(size) + big(0) + big(0);
  const std::string component = "\0\1\x0f\1\1"s;
  const std::string coding = "\xff\x52\0\x0c\0\0\0\1\0\5\4\4\0\1"s;
  const std::string steps = "\xff\x5c\0\x13\x40"s + std::string(16, '\x80');
  const std::string tile = "\xff\x90\0\x0a\0\0"s + big(20) + "\0\1\xff\x93"s;
  const std::string emptyPackets(6, '\0');
  return start + sizes + sizes + component + coding + steps + tile + emptyPackets + "\xff\xd9";
}

/// A JPEG file that ends in its second marker. An assertion of GDCM 3.0 ends the program.
const std::string AbortingJpeg = "\xff\xd8\xff\xe0"s;

/// A slice behind the three of the phantom, at which the decoder crashes.
Elements CrashingSlice(int slice)
{
  StoredVolume behind = phantom::Stored(0);
  behind.originMm += 3.0 * behind.axesMm[2];
  DicomOptions options;
  options.instance = 3;
  return Encapsulated(phantom_dicom::SliceElements(behind, slice, options), AbortingJpeg);
}

std::size_t OpenDescriptors()
{
  using Entry = std::filesystem::directory_iterator;
  return std::size_t(std::distance(Entry("/proc/self/fd"), Entry()));
}

class Decoder : public DicomReading
{
protected:
  void SetUp() override { this->descriptors = OpenDescriptors(); }

  /// No test leaves a process, not even a zombie, or a descriptor.
  void TearDown() override
  {
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
    EXPECT_EQ(OpenDescriptors(), this->descriptors);
  }

  /// Reads what cannot be read, and returns the sentence.
  std::string Refusal(const std::string& name)
  {
    const ExpectedVtkErrors errors;
    EXPECT_EQ(this->Read(name)->GetNumberOfPoints(), 0);
    return this->reader->GetErrorMessage();
  }

  std::string RefusalOfFile(const std::string& name, const std::string& bytes)
  {
    this->folder.Write("scan/" + name, bytes);
    return this->Refusal(name);
  }

  static void ExpectWords(const std::string& sentence, const std::vector<std::string>& words)
  {
    for (const std::string& word : words)
    {
      EXPECT_NE(sentence.find(word), std::string::npos) << sentence;
    }
  }

  /// The path of a program that runs this line.
  std::string Program(const std::string& line)
  {
    const std::string path = this->folder.Write("program", "#!/bin/sh\n" + line + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
  }
  std::string HangingProgram() { return this->Program("exec /bin/sleep 60"); }

  std::size_t descriptors = 0;
};

TEST_F(Decoder, ServesAllReadsOfASession)
{
  const std::string starts = this->folder.Path("starts");
  const OtherDecoder decoder(this->Program("echo >>'" + starts + "'; exec '" DECODER_PROGRAM "'"));
  this->Write("a.dcm", Slice(0));
  const auto expectStarts = [&](int count)
  { EXPECT_EQ(this->folder.Bytes("starts"), std::string(std::size_t(count), '\n')); };
  {
    const varimarch::DecoderSession session;
    for (int read = 0; read < 3; ++read)
    {
      EXPECT_GT(this->Read("a.dcm")->GetNumberOfPoints(), 0);
    }
    expectStarts(1);
  }
  this->Read("a.dcm");
  expectStarts(2);
}

TEST_F(Decoder, ThatCrashesIsASentence)
{
  this->Write("a.dcm", Encapsulated(Slice(0), AbortingJpeg), JpegSyntax);
  ExpectWords(this->Refusal("a.dcm"), { "a.dcm\": expected", "Aborted" });
}

TEST_F(Decoder, ThatCrashesLeavesTheOtherSlices)
{
  for (const int slice : { 0, 1, 2 })
  {
    this->Write(std::to_string(slice) + ".dcm", Slice(slice));
    this->Write("bad" + std::to_string(slice) + ".dcm", CrashingSlice(slice), JpegSyntax);
  }
  this->Read();
  this->ExpectPhantom();
  for (const char* name : { "bad0.dcm", "bad1.dcm", "bad2.dcm" })
  {
    this->ExpectWarning(name);
  }
  this->ExpectWarning("Aborted");
}

TEST_F(Decoder, ThatWantsMoreMemoryThanAnImageNeedsDoesNotGetIt)
{
  // 15000 x 15000 values of 32 bits take 900 MB.
  this->Write("a.dcm", Encapsulated(Slice(0), Jpeg2000Bytes(15000)), Jpeg2000Syntax);
  ExpectWords(this->Refusal("a.dcm"), { "a.dcm\": expected" });
  rusage usage = {};
  getrusage(RUSAGE_CHILDREN, &usage);
  EXPECT_LT(usage.ru_maxrss, 600e3) << "in kB";
}

TEST_F(Decoder, LearnsNothingOfTheProgramThatReads)
{
  const std::string seen = this->folder.Path("seen");
  const OtherDecoder other(this->Program(
    "/usr/bin/env >" + seen + "; echo \"$*\" >>" + seen + "; ls -l /proc/self/fd >>" + seen));
  setenv("PATIENT", "Doe^Jane", 1);
  const int inherited = open(this->folder.Write("Doe", "").c_str(), O_RDONLY);
  this->RefusalOfFile("a.vti", VtiText(phantom::Stored(0)));
  close(inherited);
  unsetenv("PATIENT");
  const std::string text = this->folder.Bytes("seen");
  ExpectWords(text, { "LC_ALL=" });
  EXPECT_EQ(text.find("Doe"), std::string::npos) << text;
  EXPECT_EQ(text.find("a.vti"), std::string::npos) << text;
}

// The signal of Ctrl+C goes to the whole group of the program that reads.
TEST_F(Decoder, IsInAProcessGroupOfItsOwn)
{
  const std::string seen = this->folder.Path("seen");
  const OtherDecoder other(this->Program("read -r status </proc/self/stat; echo $status >" + seen));
  this->RefusalOfFile("a.vti", VtiText(phantom::Stored(0)));
  std::istringstream status(this->folder.Bytes("seen"));
  int process = 0;
  int parent = 0;
  int group = -1;
  std::string name;
  std::string state;
  status >> process >> name >> state >> parent >> group;
  EXPECT_EQ(parent, getpid());
  EXPECT_EQ(group, process);
}

// A file in memory that becomes shorter would end the program that reads.
TEST_F(Decoder, CannotShortenTheMemoryThatItShares)
{
  const std::string seen = this->folder.Path("seen");
  const OtherDecoder other(
    this->Program("if (: >/proc/self/fd/4) 2>/dev/null; then echo shortened >" + seen +
      "; else echo refused >" + seen + "; fi"));
  this->RefusalOfFile("a.vti", VtiText(phantom::Stored(0)));
  EXPECT_EQ(this->folder.Bytes("seen"), "refused\n");
}

TEST_F(Decoder, IsNamedIfItIsMissing)
{
  const OtherDecoder none(this->folder.Path("none"));
  ExpectWords(this->RefusalOfFile("a.vti", VtiText(phantom::Stored(0))),
    { "a.vti\": expected the program", this->folder.Path("none"), "No such file" });
}

TEST_F(Decoder, IsNotNeededForOwnFormats)
{
  const OtherDecoder none(this->folder.Path("none"));
  const StoredVolume volume = phantom::Stored(0);
  this->folder.Write("scan/a.nrrd",
    NrrdHeaderText(volume) + "endian: little\nencoding: raw\n\n" + VoxelBytes(volume));
  this->Read("a.nrrd");
  this->ExpectPhantom();
}

TEST_F(Decoder, OfAnotherKindIsRefused)
{
  const OtherDecoder other("/bin/true");
  ExpectWords(this->RefusalOfFile("a.vti", VtiText(phantom::Stored(0))),
    { "expected the program \"/bin/true\"", "the exit code 0" });
}

TEST_F(Decoder, OfAnotherVersionIsRefused)
{
  // A greeting of five letters, as the decoder of a version 0.0.1 would send it.
  const OtherDecoder other(
    this->Program("printf '\\0\\0\\0\\0\\0\\0\\0\\0\\5\\0\\0\\0\\0\\0\\0\\0' "
                  ">&3; printf 0.0.1 >&3; exec /bin/sleep 60"));
  ExpectWords(this->RefusalOfFile("a.vti", VtiText(phantom::Stored(0))),
    { "of Varimarch", "found another one" });
}

TEST_F(Decoder, ThatHangsIsEnded)
{
  const OtherDecoder other(this->HangingProgram());
  this->reader->SetLongestSilence(0.2);
  ExpectWords(this->RefusalOfFile("a.vti", VtiText(phantom::Stored(0))),
    { "a.vti\": expected", "no progress for 0.2 seconds" });
}

TEST_F(Decoder, ThatHangsCanBeCancelled)
{
  const OtherDecoder other(this->HangingProgram());
  vtkNew<vtkCallbackCommand> cancel;
  cancel->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  this->reader->AddObserver(vtkCommand::ProgressEvent, cancel);
  this->folder.Write("scan/a.vti", VtiText(phantom::Stored(0)));
  this->Read("a.vti");
  EXPECT_EQ(this->reader->GetErrorCode(), vtkErrorCode::UserError);
}

TEST_F(Decoder, WorksWithoutStandardInputAndOutput)
{
  this->folder.Write("scan/a.vti", VtiText(phantom::Stored(0)));
  std::vector<int> kept;
  for (const int standard : { 0, 1, 2 })
  {
    kept.push_back(dup(standard));
  }
  for (const int standard : { 0, 1, 2 })
  {
    close(standard);
  }
  this->Read("a.vti");
  for (const int standard : { 0, 1, 2 })
  {
    dup2(kept[std::size_t(standard)], standard);
    close(kept[std::size_t(standard)]);
  }
  this->ExpectPhantom();
}

TEST_F(Decoder, ServesManyThreads)
{
  for (const int slice : { 0, 1, 2 })
  {
    this->Write(std::to_string(slice) + ".dcm", Slice(slice));
  }
  this->folder.Write("a.vti", VtiText(phantom::Stored(0)));
  std::array<int, 8> right = {};
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < right.size(); ++i)
  {
    threads.emplace_back(
      [this, i, &right]
      {
        vtkNew<vtkVolumeFileReader> own;
        own->SetFileName(this->folder.Path(i % 2 == 0 ? "scan" : "a.vti").c_str());
        for (int repeat = 0; repeat < 5; ++repeat)
        {
          own->Modified();
          own->Update();
          const bool isRight = own->GetOutput()->GetNumberOfPoints() == 60 &&
            own->GetOutput()->GetScalarComponentAsDouble(1, 2, 1, 0) ==
              phantom::ValueAt({ 1, 2, 1 });
          right[i] += isRight ? 1 : 0;
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(right, (std::array<int, 8>{ 5, 5, 5, 5, 5, 5, 5, 5 }));
}

TEST_F(Decoder, IsIndependentOfTheDisplayOfWarnings)
{
  const std::string vti = VtiText(phantom::Stored(0));
  this->Write("a.dcm", Encapsulated(Slice(0), AbortingJpeg), JpegSyntax);
  this->folder.Write("scan/a.vti", vti.substr(0, vti.size() / 2) + "</VTKFile>");
  for (const char* name : { "a.dcm", "a.vti" })
  {
    const std::string sentence = this->Refusal(name);
    vtkObject::GlobalWarningDisplayOff();
    EXPECT_EQ(this->Refusal(name), sentence);
    vtkObject::GlobalWarningDisplayOn();
  }
}

}
