// Words that would act as script, markup, commands or formulas if carom wrote them into its outputs
// without escaping. None is longer than a name may be.
#pragma once

#include <string>
#include <vector>

namespace carom::test {

/// If one of them were executed, it would set the attribute `pwned` of a document, create the file
/// `pwned`, or set the text of `canary.tex`.
inline const std::vector<std::string> hostile_words{"<script>pwned()</script>",
                                                    "\"><img src=x onerror=pwned()>",
                                                    "'><svg onload=pwned()>",
                                                    "<b>bold</b> &lt;i&gt; &#60;u&#62;",
                                                    "]]><script>pwned()</script>",
                                                    "--><script>pwned()</script><!--",
                                                    "</title></text><script>pwned()</script>",
                                                    "<?php pwned() ?><!DOCTYPE x>",
                                                    "00:00.000 --> 99:59.000",
                                                    "NOTE STYLE WEBVTT",
                                                    "[a](javascript:pwned()) ![b](x)",
                                                    "\\input{canary}",
                                                    "\\immediate\\write18{touch pwned}",
                                                    "$(touch pwned) `touch pwned`",
                                                    "'; touch pwned; '",
                                                    "{% include canary %} {{ site.title }}",
                                                    "http://a.bc www.a.bc a@a.bc doi:10.1/a",
                                                    "${PATH} %s %n {0} {}",
                                                    "=cmd|' /C calc'!A0",
                                                    "+1, @SUM(A1), -2",
                                                    "\u202egnp.\u2066live\u2069"};

/// All of these words, joined by spaces into one text.
inline std::string all_hostile_words() {
    std::string all;
    for (const std::string& words : hostile_words) all += (all.empty() ? "" : " ") + words;
    return all;
}

}  // namespace carom::test
