#include <gtest/gtest.h>

#include "tools/terminal/terminal.h"

namespace crowd::line_block_test {
namespace {

// Carriage return; ESC[K: clear to the end of the line; ESC[J: clear all below; ESC[nA: n lines up.

TEST(LineBlock, DrawsASingleLineInPlace) {
  LineBlock block;
  EXPECT_EQ(block.draw({"one"}, 80), "\rone\x1b[K");
  EXPECT_EQ(block.draw({"two"}, 80), "\rtwo\x1b[K");
  EXPECT_EQ(block.clear(), "\r\x1b[K");
}

TEST(LineBlock, DrawsSeveralLinesInPlace) {
  LineBlock block;
  EXPECT_EQ(block.draw({"one", "two", "bar"}, 80), "\rone\x1b[K\ntwo\x1b[K\nbar\x1b[K");
  EXPECT_EQ(block.draw({"1", "2", "3"}, 80), "\x1b[2A\r1\x1b[K\n2\x1b[K\n3\x1b[K");
  EXPECT_EQ(block.draw({"bar"}, 80), "\x1b[2A\rbar\x1b[K\x1b[J");  // two lines less
  EXPECT_EQ(block.draw({"one", "bar"}, 80), "\rone\x1b[K\nbar\x1b[K");
  EXPECT_EQ(block.clear(), "\x1b[1A\r\x1b[J");
}

TEST(LineBlock, ClearsTheScreenOfATerminalOfAnotherWidth) {
  LineBlock block;
  block.draw({"one", "bar"}, 80);
  EXPECT_EQ(block.draw({"1", "2"}, 60),
            "\x1b[H\x1b[J"
            "1\x1b[K\n2\x1b[K");
  EXPECT_EQ(block.draw({"1", "2"}, 60), "\x1b[1A\r1\x1b[K\n2\x1b[K");
}

}  // namespace
}  // namespace crowd::line_block_test
