// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MadeDicom.h"
#include "TestClass.h"
#include "document/Document.h"
#include "document/FileBytes.h"
#include "document/container/ZipReader.h"
#include "document/scene/BodyImport.h"
#include "document/volume/ImageFiles.h"
#include "document/volume/VolumeKind.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

namespace fs = std::filesystem;

// A patient's name, which stands in folders, names of files and fields of headers.
const std::string kPatient = "Zentinel";

// Returns true if bytes contain the patient's name in upper or lower case, as text of one or two bytes.
bool names(std::string bytes) {
  std::transform(bytes.begin(), bytes.end(), bytes.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
  std::string name = kPatient, wide;
  name.front() = 'z';
  for (const char c : name) wide += {c, '\0'};
  return bytes.find(name) != std::string::npos || bytes.find(wide) != std::string::npos;
}

// Returns the part of a file that contains the patient's name; of an archive each entry is unpacked.
std::string whereNamed(const fs::path& path) {
  const Result<std::string> bytes = readFileBytes(path);
  if (!bytes) return "not read";
  if (names(*bytes)) return "the file";
  if (!bytes->starts_with("PK")) return {};
  constexpr std::uint64_t kMost = 1 << 30;
  ZipReader zip(*bytes, {kMost, kMost});
  for (const std::string& entry : zip.names()) {
    const Result<std::string> unpacked = zip.read(entry);
    if (!unpacked) return "not unpacked: " + entry;
    if (names(entry) || names(*unpacked)) return entry;
  }
  return {};
}

template <class Number>
void putNumber(std::string& bytes, std::size_t at, Number number) {
  std::copy_n(reinterpret_cast<const char*>(&number), sizeof(number), bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

// Samples of a ball in 16³.
std::string ballSamples() {
  std::string bytes;
  for (int z = 0; z < 16; ++z)
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const auto value = static_cast<std::int16_t>(x * x + y * y + z * z < 140 ? 1000 : -1000 + x);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
      }
  return bytes;
}

std::string niftiOf(const std::string& samples) {
  std::string bytes(352, '\0');
  putNumber<std::int32_t>(bytes, 0, 348);
  const std::array<std::int16_t, 4> size{3, 16, 16, 16};
  for (std::size_t k = 0; k < size.size(); ++k) putNumber(bytes, 40 + 2 * k, size[k]);
  putNumber<std::int16_t>(bytes, 70, 4);
  for (std::size_t k = 0; k < 4; ++k) putNumber(bytes, 76 + 4 * k, 1.0f);
  putNumber(bytes, 108, 352.0f);
  bytes[123] = 2;
  for (const std::size_t at : {148, 228, 328}) bytes.replace(at, 13, kPatient + " Anna");  // descrip, aux_file, intent
  bytes.replace(344, 4, std::string("n+1\0", 4));
  return bytes + samples;
}

}  // namespace

// Nothing that is written names the patient, although folders, files and headers of all formats do.
class PrivateNamesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    m_root = m_folder.path().toStdString();
    m_private = m_root / (kPatient + "^Anna");
    fs::create_directories(m_private / (kPatient + "Series"));
    fs::create_directories(m_root / "shared");
    const auto put = [&](const std::string& name, const std::string& bytes) {
      std::ofstream(m_private / name, std::ios::binary) << bytes;
    };
    const std::string samples = ballSamples();
    put(kPatient + ".nii", niftiOf(samples));
    put(kPatient + ".nrrd", "NRRD0004\n# " + kPatient +
                                "\ntype: short\ndimension: 3\nsizes: 16 16 16\nspacings: 1 1 1\ncontent: " + kPatient +
                                "\nendian: little\nencoding: raw\npatient:=" + kPatient + "\n\n" + samples);
    put(kPatient + ".mha", "ObjectType = Image\nNDims = 3\nDimSize = 16 16 16\nElementSpacing = 1 1 1\nComment = " +
                               kPatient + "\nElementType = MET_SHORT\nElementDataFile = LOCAL\n" + samples);
    put(kPatient + ".raw", samples);
    put(kPatient + ".raw.json", R"({"raw": ")" + kPatient + R"(.raw", "size": [16, 16, 16], "type": "int16"})");
    for (int i = 0; i < 4; ++i) {
      test::MadeSlice slice;
      slice.origin.z() = i;
      std::string bytes = test::dicomOf(slice);
      // The patient's name is that of MadeDicom.h, of sixteen letters.
      bytes.replace(bytes.find("Mustermann^Erika"), 16, kPatient + "^AnnaXXX");
      put(kPatient + "Series/" + kPatient + std::to_string(i), bytes);
    }
  }

  void documents_data() {
    QTest::addColumn<QString>("file");
    for (const char* ending : {".nii", ".nrrd", ".mha", ".raw.json", "Series", "Series/Zentinel0"})
      QTest::addRow("%s", ending) << QString::fromStdString(kPatient + ending);
  }
  void documents() {
    QFETCH(QString, file);
    std::vector<std::unique_ptr<DocumentKind>> all;
    all.push_back(std::make_unique<VolumeKind>());
    const DocumentKinds kinds(std::move(all));
    const fs::path path = m_private / file.toStdString();
    QVERIFY(isPrivateName(path));
    QVERIFY(!names(sourceName(path)));
    Result<OpenedFile> opened = kinds.open(path, {});
    QVERIFY(opened.hasValue());
    QVERIFY(opened->file.hasPrivateName);
    const DocumentKind& kind = *opened->kind;
    for (const std::string& ending : writtenEndings(kind.formats())) {
      const fs::path shared = m_root / "shared" / ("mine" + ending);
      QVERIFY(saveDocument(kind, opened->file, *opened->content, shared).hasValue());
      QVERIFY2(whereNamed(shared).empty(), (ending + ": " + whereNamed(shared)).c_str());
    }
    QVERIFY(!names(kind.describe(*opened->content).dump()));
    // A body of another document is copied, and called otherwise.
    const Result<ImportedBody> body = readBody(kinds, path, !fs::is_directory(path), {});
    QVERIFY(body.hasValue());
    QVERIFY(!body->body.link && !names(body->body.name));
    // The window shows what was opened, and proposes another name.
    const std::unique_ptr<Document> document = kind.make(std::move(*opened));
    QVERIFY(names(document->name().toStdString()));
    QVERIFY(!names(document->sharedName().toStdString()));
  }

  // The search finds what it looks for, also in a packed entry.
  void searched() {
    Container container;
    container.blobs["blob"] = std::string(5000, 'x') + "zenTINEL" + std::string(5000, 'x');
    const Result<std::string> bytes = writeContainer(container, Compression::Fast);
    QVERIFY(bytes && !names(*bytes));
    const fs::path path = m_root / "shared" / "found.handwheel";
    std::ofstream(path, std::ios::binary) << *bytes;
    QCOMPARE(whereNamed(path), std::string("blob"));
  }

 private:
  const QTemporaryDir m_folder;
  fs::path m_root, m_private;
};

HANDWHEEL_TEST(PrivateNamesTest)
#include "PrivateNamesTest.moc"
