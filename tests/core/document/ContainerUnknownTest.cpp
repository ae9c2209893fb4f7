// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ContainerChecks.h"
#include "TestClass.h"
#include "document/container/UnknownPart.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

Container containing(json manifest, std::map<std::string, std::string> blobs = {}) {
  Container container;
  *container.manifest = std::move(manifest);
  container.blobs = std::move(blobs);
  return container;
}

// Removes some keys of objects, at any depth.
json thinned(const json& object) {
  json kept = json::object();
  for (const auto& [key, value] : object.items())
    if (*rc::gen::inRange(0, 3) != 0) kept[key] = value.is_object() ? thinned(value) : value;
  return kept;
}

bool hasNull(const json& value) {
  if (value.is_null()) return true;
  return value.is_structured() && std::any_of(value.begin(), value.end(), hasNull);
}

}  // namespace

class ContainerUnknownTest : public QObject {
  Q_OBJECT

 private slots:
  void example() {
    const Container read =
        containing({{"kind", "mesh"}, {"author", "A"}, {"document", {{"faces", 3}, {"mood", "good"}}}},
                   {{"mesh/0", "x"}, {"mesh/7", "stale"}, {"photo.png", "y"}});
    const Container ours = containing({{"kind", "mesh"}, {"document", {{"faces", 5}}}}, {{"mesh/0", "z"}});
    const std::vector<std::string> folders{"mesh/"};
    const Container unknown = unknownPart(read, ours, folders);
    QVERIFY(*unknown.manifest == json({{"author", "A"}, {"document", {{"mood", "good"}}}}));
    QVERIFY(unknown.blobs == (std::map<std::string, std::string>{{"photo.png", "y"}}));
    const Container saved = merged(unknown, ours);
    QVERIFY(*saved.manifest ==
            json({{"kind", "mesh"}, {"author", "A"}, {"document", {{"faces", 5}, {"mood", "good"}}}}));
    QVERIFY(saved.blobs == (std::map<std::string, std::string>{{"mesh/0", "z"}, {"photo.png", "y"}}));
  }

  // A program that understands only part of a file, and changes nothing, writes the same file.
  void nothingIsLost() {
    QVERIFY(rc::check([] {
      const Container read = anyContainer();
      Container ours;
      *ours.manifest = thinned(*read.manifest);
      for (const auto& blob : read.blobs)
        if (*rc::gen::arbitrary<bool>()) ours.blobs.insert(blob);
      const Container saved = merged(unknownPart(read, ours, {}), ours);
      RC_ASSERT(*saved.manifest == *read.manifest);
      RC_ASSERT(saved.blobs == read.blobs);
    }));
  }

  // The keys that this program writes win.
  void oursWins() {
    QVERIFY(rc::check([] {
      const Container read = anyContainer(), ours = anyContainer();
      const Container saved = merged(unknownPart(read, ours, {}), ours);
      RC_ASSERT(*merged(saved, ours).manifest == *saved.manifest);  // nothing of ours is missing or different
      RC_ASSERT(unknownPart(ours, saved, {}).manifest->empty());
      RC_ASSERT(unknownPart(read, saved, {}).manifest->empty());  // nor is anything that was read
      for (const auto& [name, bytes] : ours.blobs) RC_ASSERT(saved.blobs.at(name) == bytes);
    }));
  }

  // The library's RFC 7386 agrees if there is no null.
  void mergesAsTheStandardSays() {
    QVERIFY(rc::check([] {
      const Container below = anyContainer(), above = anyContainer();
      RC_PRE(!hasNull(*above.manifest));
      json expected = *below.manifest;
      expected.merge_patch(*above.manifest);
      RC_ASSERT(*merged(below, above).manifest == expected);
    }));
  }

  void nullIsAValue() {
    const Container saved = merged(containing({{"a", {{"b", 1}}}, {"c", 2}}), containing({{"a", nullptr}}));
    QVERIFY(*saved.manifest == json({{"a", nullptr}, {"c", 2}}));
  }
};

HANDWHEEL_TEST(ContainerUnknownTest)
#include "ContainerUnknownTest.moc"
