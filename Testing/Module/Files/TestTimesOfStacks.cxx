// Times of files that list their slices: TIFF, MINC and PAR/REC.
#include "Module/Files/PhantomFormats.h"
#include "Module/Files/PhantomLibraryFiles.h"
#include "Module/Files/TimesOfFiles.h"

#include <vtkStringArray.h>

namespace
{

TEST_F(VolumeTimes, OfTiffAreFramesOrTheDimensionOfOme)
{
  StoredVolume all = phantom::Stored(0);
  all.values.clear();
  all.dimensions[2] *= timeCount;
  for (int time = 0; time < timeCount; ++time)
  {
    const StoredVolume one = AtTime(time);
    all.values.insert(all.values.end(), one.values.begin(), one.values.end());
  }
  const auto write = [&](const std::string& name, const std::string& description)
  {
    TiffOptions options;
    options.description = description;
    WriteTiff(this->folder.Path(name), all, options);
    return this->folder.Path(name);
  };
  const std::string imageJ = "ImageJ=1.53t\nimages=12\nslices=3\nframes=4\n";
  this->ExpectNumbers(write("n.tif", imageJ));
  this->ExpectSeconds(write("s.tif", imageJ + "finterval=1.5\n"), { 0.0, 1.5, 3.0, 4.5 });
  this->ExpectSeconds(
    write("min.tif", imageJ + "finterval=0.5\ntunit=min\n"), { 0.0, 30.0, 60.0, 90.0 });
  const auto ome = [](const std::string& increment)
  {
    return R"(<?xml version="1.0" encoding="UTF-8"?><OME xmlns=
      "http://www.openmicroscopy.org/Schemas/OME/2016-06"><Image ID="Image:0"><Pixels ID="Pixels:0"
      DimensionOrder="XYZCT" Type="int16" SizeX="5" SizeY="4" SizeZ="3" SizeC="1" SizeT="4" )" +
      increment + "><TiffData/></Pixels></Image></OME>";
  };
  this->ExpectNumbers(write("n.ome.tif", ome("")));
  this->ExpectSeconds(write("s.ome.tif", ome(R"(TimeIncrement="250" TimeIncrementUnit="ms")")),
    { 0.0, 0.25, 0.5, 0.75 });
}

TEST_F(VolumeTimes, OfMincAreAnAxis)
{
  const StoredVolume volume = phantom::Stored(0);
  MincOptions options;
  options.timeCount = timeCount;
  WriteMinc1(this->folder.Path("n.mnc"), volume, options);
  WriteMinc2(this->folder.Path("n2.mnc"), volume, options);
  options.timeStepSeconds = 1.5;
  WriteMinc1(this->folder.Path("s.mnc"), volume, options);
  WriteMinc2(this->folder.Path("s2.mnc"), volume, options);
  for (const char* const version : { ".mnc", "2.mnc" })
  {
    this->ExpectNumbers(this->folder.Path(std::string("n") + version));
    this->ExpectSeconds(this->folder.Path(std::string("s") + version), { 0.0, 1.5, 3.0, 4.5 });
  }
}

TEST_F(VolumeTimes, OfParRecAreTheImagesOfEachSlice)
{
  const StoredVolume volume = phantom::Stored(0);
  const std::vector<int> slices = { 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2 };
  this->folder.Write("n.REC", VoxelsOfTimes());
  this->ExpectNumbers(this->folder.Write("n.PAR", ParText(volume, slices)));
  this->folder.Write("s.REC", VoxelsOfTimes());
  this->ExpectSeconds(
    this->folder.Write("s.PAR", ParText(volume, slices, 2.5)), { 0.0, 2.5, 5.0, 7.5 });
  this->folder.Write("cut.REC", VoxelsOfTimes());
  const std::vector<int> begun = { 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1 };
  this->ExpectNumbers(this->folder.Write("cut.PAR", ParText(volume, begun)));
  EXPECT_EQ(this->reader->GetWarnings()->GetValue(0),
    "2 images of volumes that are not complete were left out.");
}

}
