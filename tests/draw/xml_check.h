// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file xml_check.h
/// A strict reader of the XML that the SVG writer may produce: elements, quoted attributes, text,
/// the five named entities and numeric ones. It detects open tags, unescaped characters and
/// repeated attributes.

#include <cctype>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace hawser::test {

struct XmlDocument {
    std::vector<std::string> elements;  ///< Names in order.
    std::vector<std::string> texts;     ///< Text content, with entities decoded to ASCII.
};

class XmlReader {
  public:
    explicit XmlReader(const std::string& text) : s_(text) {}

    XmlDocument read() {
        if (s_.rfind("<?xml", 0) == 0) at_ = s_.find("?>") + 2;
        skip_blanks();
        element();
        skip_blanks();
        if (at_ != s_.size()) fail("content after the root");
        return out_;
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw std::runtime_error(why + " at byte " + std::to_string(at_));
    }
    char peek() const { return at_ < s_.size() ? s_[at_] : '\0'; }
    char next() {
        if (at_ >= s_.size()) fail("the document ends early");
        return s_[at_++];
    }
    void expect(char c) {
        if (next() != c) fail(std::string("expected ") + c);
    }
    void skip_blanks() {
        while (std::isspace(static_cast<unsigned char>(peek())) != 0) ++at_;
    }
    std::string name() {
        std::string out;
        while (std::isalnum(static_cast<unsigned char>(peek())) != 0 || peek() == '-' ||
               peek() == ':' || peek() == '_')
            out += next();
        if (out.empty()) fail("expected a name");
        return out;
    }
    std::string entity() {
        std::string code;
        while (peek() != ';') code += next();
        expect(';');
        static const std::set<std::string> known{"amp", "lt", "gt", "quot"};
        if (code == "amp") return "&";
        if (code == "lt") return "<";
        if (code == "gt") return ">";
        if (code == "quot") return "\"";
        if (code.size() > 1 && code[0] == '#') {
            const int value = std::stoi(code.substr(1));
            return value < 128 ? std::string(1, static_cast<char>(value)) : "?";
        }
        fail("unknown entity " + code);
    }
    void attributes() {
        std::set<std::string> seen;
        for (skip_blanks(); peek() != '>' && peek() != '/'; skip_blanks()) {
            if (!seen.insert(name()).second) fail("an attribute is given twice");
            expect('=');
            expect('"');
            while (peek() != '"') {
                const char c = next();
                if (c == '<') fail("< in an attribute");
                if (c == '&') (void)entity();
            }
            expect('"');
        }
    }
    void element() {
        expect('<');
        const std::string tag = name();
        out_.elements.push_back(tag);
        attributes();
        if (peek() == '/') {
            ++at_;
            expect('>');
            return;
        }
        expect('>');
        std::string text;
        while (true) {
            if (s_.compare(at_, 2, "</") == 0) break;
            if (peek() == '<') {
                element();
            } else {
                const char c = next();
                text += c == '&' ? entity() : std::string(1, c);
            }
        }
        if (text.find_first_not_of(" \n") != std::string::npos) out_.texts.push_back(text);
        at_ += 2;
        if (name() != tag) fail("the end tag does not match " + tag);
        expect('>');
    }

    const std::string& s_;
    std::size_t at_ = 0;
    XmlDocument out_;
};

}  // namespace hawser::test
