// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/Container.h"

#include "ContainerChecks.h"
#include "TestClass.h"

#include <QTest>
#include <cstdlib>
#include <ctime>

using namespace handwheel;
using namespace handwheel::test;

namespace {

Container containerSample() {
  Container container;
  *container.manifest = {{"id", "17"}, {"kind", "mesh"}, {"document", {{"vertices", 3}}}};
  container.blobs["mesh/positions/0000"] = toBlob<double>({0.0, 1.5, -2.0});
  container.blobs["mesh/faces/0000"] = toBlob<std::uint32_t>({0, 1, 2});
  return container;
}

std::string written(const Container& container, Compression compression = Compression::Fast) {
  const auto bytes = writeContainer(container, compression);
  return bytes ? *bytes : std::string();
}

}  // namespace

class ContainerTest : public QObject {
  Q_OBJECT

 private slots:
  void readsBackTheSame() {
    QVERIFY(rc::check([] {
      const Container container = anyContainer();
      const auto compression = *rc::gen::element(Compression::None, Compression::Fast);
      const auto bytes = writeContainer(container, compression);
      RC_ASSERT(bytes.hasValue());
      RC_ASSERT(looksLikeContainer(*bytes));
      const auto read = readContainer(*bytes);
      RC_ASSERT(read.hasValue());
      RC_ASSERT(read->damage.empty() && !read->isNewer);
      RC_ASSERT(ownPart(*read->container.manifest) == *container.manifest);
      RC_ASSERT(read->container.blobs == container.blobs);
    }));
  }

  void writesTheSameBytes() {
    const std::string before = written(containerSample());
    setenv("TZ", "Pacific/Auckland", 1);
    tzset();
    const std::string after = written(containerSample());
    unsetenv("TZ");
    tzset();
    QVERIFY(!before.empty());
    QVERIFY(before == after);
    const auto read = readContainer(before);
    QVERIFY(read);
    QVERIFY(written(read->container) == before);
  }

  // Python's zipfile and zlib check the layout that docs/format.md describes.
  void othersCanReadIt() {
    const QString program =
        "import io, json, sys, zipfile, zlib\n"
        "z = zipfile.ZipFile(io.BytesIO(sys.stdin.buffer.read()))\n"
        "assert z.testzip() is None\n"
        "m = json.loads(z.read('manifest.json'))\n"
        "assert z.read('manifest.copy.json') == z.read('manifest.json')\n"
        "for name, entry in m['blobs'].items():\n"
        "  b = z.read(name)\n"
        "  assert len(b) == entry['bytes'] and '%08x' % zlib.crc32(b) == entry['crc32'], name\n"
        "print(z.namelist(), m['handwheel']['format'], m['kind'], len(m['blobs']))\n";
    for (Compression compression : {Compression::None, Compression::Fast})
      QCOMPARE(python(program, written(containerSample(), compression)),
               QString("['manifest.json', 'mesh/faces/0000', 'mesh/positions/0000', 'manifest.copy.json'] %1 mesh 2")
                   .arg(kContainerVersion));
  }

  // A user unpacks the archive, and packs it again in another order, with entries for the folders.
  void readsWhatOthersPacked() {
    const QString program =
        "import io, sys, zipfile\n"
        "z = zipfile.ZipFile(io.BytesIO(sys.stdin.buffer.read()))\n"
        "o = io.BytesIO()\n"
        "with zipfile.ZipFile(o, 'w', zipfile.ZIP_DEFLATED) as n:\n"
        "  n.writestr('mesh/', '')\n"
        "  for name in reversed(z.namelist()):\n"
        "    if name != 'manifest.copy.json': n.writestr(name, z.read(name))\n"
        "  n.writestr('notes.txt', 'mine')\n"
        "print(o.getvalue().hex())\n";
    const std::string bytes = QByteArray::fromHex(python(program, written(containerSample())).toLatin1()).toStdString();
    QVERIFY(looksLikeContainer(bytes));
    const auto read = readContainer(bytes);
    QVERIFY(read);
    QVERIFY(read->damage.empty());
    Container expected = containerSample();
    expected.blobs["notes.txt"] = "mine";
    QVERIFY(read->container.blobs == expected.blobs);
    QVERIFY(ownPart(*read->container.manifest) == *expected.manifest);
  }

  void keepsOtherKeysOfTheHeading() {
    Container container = containerSample();
    (*container.manifest)["handwheel"] = {{"format", 1}, {"theme", "dark"}};
    const auto read = readContainer(written(container));
    QVERIFY(read);
    QCOMPARE((*read->container.manifest)["handwheel"].value("theme", ""), "dark");
    QCOMPARE((*read->container.manifest)["handwheel"].value("format", 0), kContainerVersion);
  }

  void newerVersionsAreRecognised() {
    const std::string manifest = R"({"handwheel": {"format": 7}, "kind": "mesh", "blobs": {}, "colour": "red"})";
    const auto read = readContainer(HandmadeZip().add(HandmadeZip::stored("manifest.json", manifest)).bytes());
    QVERIFY(read);
    QVERIFY(read->isNewer);
    QCOMPARE((*read->container.manifest)["colour"].get<std::string>(), "red");
  }

  void namesThatAreNotUtf8() {
    Container container = containerSample();
    (*container.manifest)["name"] = "caf\xe9";
    const auto read = readContainer(written(container));
    QVERIFY(read);
    QCOMPARE((*read->container.manifest)["name"].get<std::string>(), "caf\xef\xbf\xbd");
  }

  void otherFilesLookDifferent() {
    const std::string threeMf = HandmadeZip().add(HandmadeZip::stored("[Content_Types].xml", "<Types/>")).bytes();
    for (const std::string& bytes : {std::string(), std::string("PK\3\4"), threeMf, std::string("solid manifest.json")})
      QVERIFY(!looksLikeContainer(bytes));
  }

  void numbersAreLittleEndian() {
    QCOMPARE(toBlob<std::uint32_t>({0x01020304, 5}), std::string("\4\3\2\1\5\0\0\0", 8));
    QCOMPARE(toBlob<double>({1.0}), std::string("\0\0\0\0\0\0\xf0\x3f", 8));
    QVERIFY(fromBlob<std::uint16_t>(std::string("\1\2\3", 3)) == std::vector<std::uint16_t>{0x0201});
    QVERIFY(rc::check(
        [](const std::vector<std::int64_t>& values) { RC_ASSERT(fromBlob<std::int64_t>(toBlob(values)) == values); }));
  }

  void cancelled() {
    JobState state;
    state.cancelled = true;
    const auto bytes = writeContainer(containerSample(), Compression::Fast, Progress(state));
    QVERIFY(!bytes && bytes.error().code == ErrorCode::Cancelled);
    const auto read = readContainer(written(containerSample()), Progress(state));
    QVERIFY(!read && read.error().code == ErrorCode::Cancelled);
  }

  void progressGoesToTheEnd() {
    JobState state;
    const auto bytes = writeContainer(containerSample(), Compression::Fast, Progress(state));
    QVERIFY(bytes);
    QCOMPARE(state.fraction.load(), 1.0);
    state.fraction = 0.0;
    QVERIFY(readContainer(*bytes, Progress(state)));
    QCOMPARE(state.fraction.load(), 1.0);
  }
};

HANDWHEEL_TEST(ContainerTest)
#include "ContainerTest.moc"
