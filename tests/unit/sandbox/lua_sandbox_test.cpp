// The sandbox: what is there, what is not, and budgets that nothing swallows.

#include <catch2/catch.hpp>
#include <chrono>

#include "host/wording.h"
#include "sandbox/state.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace lua_sandbox_test {

namespace {

/// Runs a chunk as a scenario file; returns what is wrong, without the place.
std::string failure(const std::string& body) {
  LuaFixture lua;
  lua.write("x.lua", "local fr = require 'flyrock'\n" + body + "\nreturn fr.scenario { fine = true }");
  Diagnostics diagnostics;
  lua.session.read_scenario((lua.folder / "x.lua").string(), "x.lua", diagnostics);
  return diagnostics.all().empty() ? "" : diagnostics.all().front().text;
}

}  // namespace

TEST_CASE("an error of Lua unwinds C++ frames") {
  struct Witness {
    bool& destroyed;
    ~Witness() { destroyed = true; }
  };
  LuaState state{flyrock::wording};
  bool destroyed = false;
  CHECK_THROWS_WITH(state.run(Budget::call_limit,
                              [&](lua_State* lua) {
                                Witness witness{destroyed};
                                raise(lua, "on purpose");
                              }),
                    "on purpose");
  CHECK(destroyed);
  destroyed = false;
  CHECK_THROWS_AS(state.run(Budget::call_limit,
                            [&](lua_State*) {
                              Witness witness{destroyed};
                              throw std::out_of_range("kept");
                            }),
                  std::out_of_range);
  CHECK(destroyed);
}

TEST_CASE("what would open the sandbox is not there, and says why") {
  CHECK(failure("debug.getinfo(1)") ==
        "`debug` is not available here: it would open the sandbox. print shows values, error(text) ends with "
        "the line");
  CHECK(failure("load('return 1')") ==
        "`load` is not available here: code is loaded from files with `require`");
  CHECK(failure("local x = string.dump(print)") ==
        "`string.dump` is not available here: code stays in its file");
  CHECK(failure("print(maht)") == "`maht` is not defined, did you mean `math`?");
  CHECK(failure("math.floor = nil") == "`math` cannot be changed");
  CHECK(failure("setmetatable(math, {})") == "this table is protected: it keeps its metatable");
  CHECK(failure("setmetatable({}, { __gc = function() end })") ==
        "the metamethod __gc is not available here");
  CHECK(failure("getmetatable('').__index.upper = nil") == "attempt to index a boolean value");
  CHECK(failure("local _, t = pairs(math)\nt.floor = nil") == "attempt to index a nil value (local 't')");
  LuaFixture lua;
  lua.write("binary.lua", "\x1bLua");
  CHECK(lua.load("binary.lua").find("attempt to load a binary chunk") != std::string::npos);
}

TEST_CASE("what is left out of Lua says what to use instead") {
  const std::pair<const char*, const char*> left_out[] = {
      {"math.random()", "a law a parameter for it, as { uniform: [0.3, 0.5], per: impact }"},
      {"local r = math.random", "draws from its argument `rng`: rng:uniform(a, b)"},
      {"math.randomseed(7)", "`seed`"},
      {"os.time()", "contact.time"},
      {"os.clock()", "contact.time"},
      {"os.getenv('HOME')", "is a parameter"},
      {"io.open('x')", "`require` it"},
      {"io.write('x')", "print shows values"},
      {"for line in io.lines('x') do end", "`require` it"},
      {"rawset({}, 1, 2)", "t[key] = value"},
      {"unpack({})", "table.unpack(t)"},
      {"bit32.band(1, 2)", "a & b"},
      {"utf8.len('x')", "`string`"},
      {"table.getn({})", "#t"},
      {"string.gfind('a', 'b')", "string.gmatch"},
      {"setfenv(1, {})", "the variable itself"},
  };
  for (const auto& [code, instead] : left_out) {
    INFO(code << ": " << failure(code));
    CHECK(failure(code).find("is not available here: ") != std::string::npos);
    CHECK(failure(code).find(instead) != std::string::npos);
  }
}

TEST_CASE("pairs and next go in a fixed order") {
  CHECK(failure(R"(
    local t = { z = 1, a = 2, [10] = 3, [2] = 4, [0.5] = 5, [true] = 6, [false] = 7, B = 8 }
    local order, again = {}, {}
    for k in pairs(t) do order[#order + 1] = tostring(k) end
    local k = next(t)
    while k ~= nil do again[#again + 1] = tostring(k); k = next(t, k) end
    assert(table.concat(order, " ") == "0.5 2 10 B a z false true", table.concat(order, " "))
    assert(table.concat(again, " ") == table.concat(order, " "))
    assert(next({}) == nil)
    for k in pairs(t) do t[k] = nil end
    assert(next(t) == nil))") == "");
  CHECK(failure("for k in pairs { [{}] = 1 } do end") ==
        "a table has no fixed order where a key is neither a number, a text nor a boolean");
}

TEST_CASE("texts show no addresses") {
  CHECK(failure(R"lua(
    local hidden = setmetatable({}, { __name = "mine" })
    local thread = coroutine.create(print)
    assert(tostring({}) == "table" and tostring(print) == "function" and tostring(thread) == "thread")
    assert(tostring(hidden) == "table" and tostring(string) == "table" and tostring(coroutine.running()) == "thread")
    assert(("%s %d"):format({}, 3) == "table 3" and ("\0%s"):format(print) == "\0function")
    assert(("%% %-10s|%.3s"):format(hidden, thread) == "% table     |thr")
    assert(("%s"):format(setmetatable({}, { __tostring = function() return "shown" end })) == "shown")
    local addresses = 0
    local function look(ok, message)
      assert(not ok)
      if tostring(message):find("0x") or tostring(message):find("%x%x%x%x%x%x") then addresses = addresses + 1 end
    end
    for _, value in ipairs { {}, print, thread, hidden } do
      look(pcall(function() return "" .. value end))
      look(pcall(function() return value + 1 end))
      look(pcall(function() return value < value end))
      look(pcall(function() return #value.x.y end))
      look(pcall(string.rep, value))
      look(pcall(string.format, "%d", value))
      look(pcall(string.format, "%q", value))
      look(pcall(table.concat, { value }))
      look(pcall(error, value))
      look(pcall(assert, false, value))
    end
    assert(addresses == 0, addresses))lua") == "");
  for (const char* pattern : {"%p", "\\0%p", "%-20p", "%5.3p", "%%%p", "%s\\0\\0%% %p"})
    CHECK(failure(std::string("local s = ('") + pattern + "'):format({}, {})") ==
          "the format %p is not available here: addresses differ from run to run");
}

TEST_CASE("sorting is stable, and no clock chooses its pivots") {
  CHECK(failure(R"lua(
    local list = {}
    for i = 1, 2000 do list[i] = { rank = (i * 7919) % 5, place = i } end
    table.sort(list, function(a, b) return a.rank < b.rank end)
    for i = 2, #list do
      local a, b = list[i - 1], list[i]
      assert(a.rank < b.rank or a.rank == b.rank and a.place < b.place, i)
    end
    local t = { 3, "x" }
    assert(not pcall(table.sort, t) and not pcall(table.sort, { 1, 2 }, 5) and not pcall(table.sort, 3))
    local words = { "b", "a", "" }
    table.sort(words)
    assert(table.concat(words, ",") == ",a,b")
    table.sort(words, function() return true end)  -- no order at all ends, too
    local shown = setmetatable({}, { __len = function() return 3 end, __index = function(_, i) return -i end,
                                     __newindex = function(_, i, v) words[i] = v end })
    table.sort(shown)
    assert(table.concat(words, ",") == "-3,-2,-1"))lua") == "");
}

TEST_CASE("ordinary Lua works in the sandbox") {
  CHECK(failure(R"lua(
    local ok, message = pcall(error, "x", 0)
    assert(not ok and message == "x")
    assert(select("#", pcall(function(...) return ... end, 1, nil, 3)) == 4)
    assert(xpcall(function(a) return a end, print, 5))
    local handled
    assert(not xpcall(function() error("y") end, function(m) handled = m end) and handled:find("y"))
    local produce = coroutine.wrap(function() for i = 1, 3 do coroutine.yield(i) end end)
    assert(produce() == 1 and produce() == 2)
    local co = coroutine.create(function() pcall(function() coroutine.yield(7); error("z") end); return 8 end)
    local _, a = coroutine.resume(co)
    local _, b = coroutine.resume(co)
    assert(a == 7 and b == 8)
    assert(("a,b"):gsub(",", ";") == "a;b" and ("x"):rep(3, "-") == "x-x-x" and ("key = 5"):match("(%w+) = (%d+)") == "key")
    local t = { 3, 1, 2 }
    table.sort(t, function(x, y) return x > y end)
    assert(table.concat(t, ",") == "3,2,1" and select("#", table.unpack(t)) == 3)
    counter = 1
    counter = counter + 1
    assert(counter == 2))lua") == "");
}

TEST_CASE("text patterns match as in Lua") {
  CHECK(failure(R"lua(
    local function same(expected, ...)
      local got = table.pack(...)
      assert(got.n == #expected, got.n)
      for i = 1, got.n do assert(got[i] == expected[i], tostring(got[i])) end
    end
    same({ 2, 4, "b" }, ("abcd"):find("(b)c."))
    same({ 3, 3 }, ("a.b.c"):gsub("%.", "-") == "a-b-c" and 3, 3)
    same({ 2, 2 }, ("a.b"):find(".", 2, true))
    same({ 4, 3 }, ("abc"):find("", 10) or 4, 3)
    same({ "  trim me " }, ("  trim me "):match("^(.*)$"))
    same({ "trim me" }, ("  trim me "):match("^%s*(.-)%s*$"))
    same({ "key", "value" }, ("key = value"):match("^(%w+)%s*=%s*(%w+)$"))
    same({ "(a(b)c)" }, ("x(a(b)c)d"):match("%b()"))
    same({ "THE (quick) fox", 1 }, ("the (quick) fox"):gsub("%f[%a]%a+", string.upper, 1))
    same({ 1, 4 }, ("abc"):match("()abc()"))
    same({ '"', "it's" }, ([[say "it's" now]]):match([[(["'])(.-)%1]]))
    same({ "x-x-x", 2 }, ("x x x"):gsub("%s", "-"))
    same({ "-a-b-", 3 }, ("ab"):gsub("", "-"))
    same({ "b=a", 1 }, ("a=b"):gsub("(%w)=(%w)", "%2=%1"))
    same({ "100%", 1 }, ("100p"):gsub("p", "%%"))
    same({ "1 $y", 2 }, ("$x $y"):gsub("%$(%w+)", { x = 1 }))
    same({ "]" }, ("a]b"):match("[]]"))
    same({ "-" }, ("a-b"):match("[a%-]", 2))
    same({ "b" }, ("a-b"):match("[^a-]"))
    same({ "0x1F" }, ("n = 0x1F;"):match("0x%x+"))
    same({ "color" }, ("color"):match("colou?r"))
    local words = {}
    for w, n in ("one=1, two=2"):gmatch("(%a+)=(%d)") do words[#words + 1] = w .. n end
    assert(table.concat(words, ";") == "one1;two2")
    for _, bad in ipairs { "%", "[a", "(a", "(a))", "%b", "%f", "%1" } do assert(not pcall(string.find, "aaa", bad), bad) end)lua") ==
        "");
}

TEST_CASE("budgets end what does not end, and nothing swallows that", "[slow]") {
  const auto start = std::chrono::steady_clock::now();
  const std::string instructions = "used more than its 100000000 instructions";
  CHECK(failure("while true do end") == instructions);
  CHECK(failure("while true do pcall(function() while true do end end) end") == instructions);
  CHECK(failure(
            "while true do xpcall(function() while true do end end, function() while true do end end) end") ==
        instructions);
  CHECK(failure("local co = coroutine.create(function() while true do end end)\nwhile true do "
                "coroutine.resume(co) end") == instructions);
  CHECK(failure("local t = setmetatable({}, { __index = function() while true do end end })\nwhile true do "
                "pcall(function() return t.x end) end") == instructions);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  CHECK(spent.count() < 5 * 4.5);
}

TEST_CASE("functions of C pay for their loops", "[slow]") {
  const std::string instructions = "used more than its 100000000 instructions";
  CHECK(failure("table.move({}, 1, 1e15, 2)") == instructions);
  CHECK(failure("(''):rep(1e15)") != "");
  CHECK(failure("local s = ('a'):rep(100)\nlocal x = s:find(('a*'):rep(50) .. 'b')") == instructions);
  CHECK(failure("local s = ('a'):rep(1e6)\nlocal x = s:find(('a'):rep(1e5) .. 'b', 1, true)") ==
        instructions);
  CHECK(failure("table.concat(setmetatable({}, { __len = function() return 1e15 // 1 | 0 end, __index = type "
                "}))") != "");
  CHECK(failure("table.insert(setmetatable({}, { __len = function() return 1 << 60 end }), 1, 1)") ==
        instructions);
  CHECK(failure("table.sort(setmetatable({}, { __len = function() return 1 << 60 end }))") == instructions);
  CHECK(failure("local s, t = ('x'):rep(1e6), {}\nfor i = 1, 200 do t[i] = s .. i end\n"
                "for i = 1, 1000 do table.sort(t) end") == instructions);
}

TEST_CASE("memory has an end that nothing swallows", "[slow]") {
  const std::string memory = "needed more than 256 MiB of memory";
  const std::string grow = "local t, s = {}, ('x'):rep(10000)\nfor i = 1, 1e9 do t[i] = s .. i end";
  CHECK(failure(grow) == memory);
  CHECK(failure("while true do pcall(function() " + grow + " end) end") == memory);
  CHECK(failure("local f = function() " + grow + " end\nwhile true do pcall(coroutine.wrap(f)) end") ==
        memory);
}

}  // namespace lua_sandbox_test
