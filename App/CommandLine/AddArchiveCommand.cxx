#include "AddArchiveCommand.h"

#include "ArchiveArguments.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace varimarch
{

namespace
{

void AddAddressOptions(CLI::App& command, ArchiveAddress& address)
{
  const std::string group = "Archive";
  command
    .add_option("ARCHIVE", address.url,
      "dicom://TITLE@host:port, where TITLE is the archive's application\n"
      "entity title; dicoms: for TLS; or the URL of DICOMweb, https:")
    ->required();
  command
    .add_option(
      "--own-title", address.ownTitle, "Our application entity title for DIMSE (default VARIMARCH)")
    ->type_name("TITLE")
    ->group(group);
  command
    .add_option("--certificate", address.certificate,
      "Certificate of the archive or its authority (PEM); needed for dicoms:")
    ->type_name("FILE")
    ->group(group);
  command
    .add_option("--own-certificate", address.ownCertificate,
      "Our certificate and its private key without a password, in one file\n"
      "(PEM), for archives that ask for it; --move with dicoms: needs it")
    ->type_name("FILE")
    ->group(group);
  command
    .add_option("--user", address.user,
      "User of DICOMweb; the password is VARIMARCH_ARCHIVE_PASSWORD of the\n"
      "environment, or is asked for")
    ->type_name("NAME")
    ->group(group);
  command
    .add_option(
      "--patience", address.patience, "Longest time without an answer in seconds (default 30)")
    ->check(CLI::Range(0.1, 86400.0).description(""))
    ->type_name("S")
    ->group(group);
}

void AddCheck(CLI::App& archive)
{
  const auto address = std::make_shared<ArchiveAddress>();
  CLI::App* app = archive.add_subcommand("check", "Ask an archive to answer");
  app->footer("Examples:\n"
              "  varimarch archive check dicom://ORTHANC@localhost:4242\n"
              "  varimarch archive check https://pacs.example.org/dicom-web --user jane");
  AddAddressOptions(*app, *address);
  app->callback([address] { RunArchiveCheck(*address); });
}

void AddFind(CLI::App& archive)
{
  const auto arguments = std::make_shared<ArchiveFindArguments>();
  CLI::App* app =
    archive.add_subcommand("find", "List studies of an archive, or the series of a study");
  app->footer(
    "Prints a table with tabs between its columns. Words may hold '*' and '?'.\n"
    "Examples:\n"
    "  varimarch archive find dicom://ORTHANC@localhost:4242 --patient-name DOE\n"
    "  varimarch archive find https://pacs.example.org/dicom-web --date 20260101- --modality CT\n"
    "  varimarch archive find dicom://ORTHANC@localhost:4242 --study 1.2.840.1");
  AddAddressOptions(*app, arguments->address);
  const auto addWord = [&](const char* name, std::string& word, const char* help, const char* type)
  { return app->add_option(name, word, help)->type_name(type)->group("Search"); };
  ArchiveQuery& query = arguments->query;
  addWord("--patient-name", query.patientName, "Beginning of the name, as DOE^J", "NAME");
  addWord("--patient-id", query.patientId, "Identity of the patient", "ID");
  addWord("--date", query.dates, "Date of the study, as 20261126, or 20260101-20261231", "DATES");
  addWord("--modality", query.modality, "CT, MR, PT ...", "NAME");
  addWord("--study", arguments->study, "List the series of this study", "UID");
  app->callback([arguments] { RunArchiveFind(*arguments); });
}

void AddGet(CLI::App& archive)
{
  const auto arguments = std::make_shared<ArchiveGetArguments>();
  CLI::App* app = archive.add_subcommand("get", "Fetch a study or a series into a folder");
  app->footer(
    "Examples:\n"
    "  varimarch archive get dicom://ORTHANC@localhost:4242 --study 1.2.840.1 -o scan\n"
    "  varimarch archive get dicom://PACS@host:104 --study 1.2.840.1 -o scan --move 11112");
  AddAddressOptions(*app, arguments->address);
  app->add_option("--study", arguments->study, "UID of the study")->type_name("UID")->required();
  app->add_option("--series", arguments->series, "UID of the only series to fetch")
    ->type_name("UID");
  app->add_option("-o,--output", arguments->folder, "The folder for the images, new or empty")
    ->type_name("FOLDER")
    ->required();
  app
    ->add_option("--move", arguments->address.returnPort,
      "Fetch by C-MOVE, to this port of this computer, which the archive must\n"
      "know by our title; otherwise by C-GET")
    ->check(CLI::Range(1, 65535).description(""))
    ->type_name("PORT");
  app->callback([arguments] { RunArchiveGet(*arguments); });
}

void AddSend(CLI::App& archive)
{
  const auto arguments = std::make_shared<ArchiveSendArguments>();
  CLI::App* app = archive.add_subcommand("send", "Send DICOM files to an archive");
  app->footer("Files are sent as they are, with what they say of the patient.\n"
              "Examples:\n"
              "  varimarch render scan -o bone.dcm --preset ct-bone\n"
              "  varimarch archive send dicom://ORTHANC@localhost:4242 bone.dcm");
  AddAddressOptions(*app, arguments->address);
  app->add_option("FILES", arguments->files, "The files to send")->required();
  app->callback([arguments] { RunArchiveSend(*arguments); });
}

}

void AddArchiveCommand(CLI::App& program)
{
  CLI::App* app = program.add_subcommand(
    "archive", "Search an archive of images (PACS), fetch from it, and send to it");
  app->require_subcommand(1);
  app->footer("varimarch archive SUBCOMMAND --help describes a subcommand, with examples.");
  AddCheck(*app);
  AddFind(*app);
  AddGet(*app);
  AddSend(*app);
}

}
