#!/usr/bin/env python3
"""Learns which words a recogniser hears in place of others, and how sure it is: espeak-ng speaks, pocketsphinx listens.

  replay/noise/learn_confusions.py [--language english] [--sentences 1200] [-o engine/knowledge/confusions/english.json]

The sentences are the lexicon's examples, spread evenly. The recogniser knows their words and which word follows which,
as one would be set up for the task; so it hears words that the avatar knows. The spoken and the heard words are aligned
(fewest changes), and each change counts. It takes half a second for a sentence. The voice is English.
"""
import argparse
import collections
import glob
import json
import math
import os
import re
import subprocess
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DICTIONARY = "/usr/share/pocketsphinx/model/en-us/cmudict-en-us.dict"
VOICES = ["en-us+f3", "en-us+m3"]
QUANTILES = 20
MOST_FOR_A_WORD = 12
SILENCE = {"<s>", "</s>", "<sil>"}


def words_of(text):
    return re.findall(r"[a-z']+", text.lower())


def examples(language):
    said = []
    for path in sorted(glob.glob(os.path.join(ROOT, "engine/knowledge/lexicon", language, "*.json"))):
        with open(path, encoding="utf-8") as file:
            for example in json.load(file).get("examples", []):
                texts = example["say"]
                said += [texts] if isinstance(texts, str) else texts
    return said


def pronunciations():
    known = collections.defaultdict(list)
    with open(DICTIONARY, encoding="utf-8") as file:
        for line in file:
            known[re.sub(r"\(\d+\)$", "", line.split()[0])].append(line)
    return known


def write_model(path, sentences):
    """Bigrams with Witten and Bell's smoothing, in ARPA's format."""
    single, pairs, before, after = collections.Counter(), collections.Counter(), collections.Counter(), collections.defaultdict(set)
    for sentence in sentences:
        whole = ["<s>", *sentence, "</s>"]
        single.update(whole[1:])
        for first, second in zip(whole, whole[1:]):
            pairs[first, second] += 1
            before[first] += 1
            after[first].add(second)
    total, vocabulary = sum(single.values()), sorted(set(single) | {"<s>"})
    lines = ["\\data\\", f"ngram 1={len(vocabulary)}", f"ngram 2={len(pairs)}", "", "\\1-grams:"]
    for word in vocabulary:
        chance = math.log10(single[word] / total) if single[word] else -99
        unseen = len(after[word]) / (before[word] + len(after[word])) if before[word] else 1
        left = max(1e-6, 1 - sum(single[next_word] / total for next_word in after[word]))
        lines.append(f"{chance:.4f} {word} {math.log10(unseen / left):.4f}")
    lines += ["", "\\2-grams:"]
    for (first, second), count in sorted(pairs.items()):
        lines.append(f"{math.log10(count / (before[first] + len(after[first]))):.4f} {first} {second}")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join([*lines, "", "\\end\\", ""]))


def hear(folder, voice, text):
    """The words with their confidences, as the recogniser prints them."""
    spoken, wave = os.path.join(folder, "a.wav"), os.path.join(folder, "b.wav")
    subprocess.run(["espeak-ng", "-v", voice, "-s", "140", "-w", spoken, text], check=True)
    subprocess.run(["ffmpeg", "-y", "-loglevel", "error", "-i", spoken, "-ar", "16000", "-ac", "1", "-af", "apad=pad_dur=0.4", wave], check=True)
    printed = subprocess.run(["pocketsphinx_continuous", "-infile", wave, "-lm", os.path.join(folder, "said.lm"), "-dict",
                              os.path.join(folder, "said.dict"), "-time", "yes", "-logfn", "/dev/null"],
                             capture_output=True, text=True, check=True).stdout
    heard = []
    for line in printed.splitlines():
        part = line.split()
        if len(part) == 4 and re.fullmatch(r"[\d.]+", part[3]) and part[0] not in SILENCE and not part[0].startswith("["):
            heard.append((re.sub(r"\(\d+\)$", "", part[0]), float(part[3])))
    return heard


def aligned(said, heard):
    """Pairs of a said word and a heard one with its confidence; None stands where there is no such word."""
    cost = [[i + j if i == 0 or j == 0 else 0 for j in range(len(heard) + 1)] for i in range(len(said) + 1)]
    for i in range(1, len(said) + 1):
        for j in range(1, len(heard) + 1):
            cost[i][j] = min(cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + (said[i - 1] != heard[j - 1][0]))
    i, j, pairs = len(said), len(heard), []
    while i or j:
        if i and j and cost[i][j] == cost[i - 1][j - 1] + (said[i - 1] != heard[j - 1][0]):
            i, j = i - 1, j - 1
            pairs.append((said[i], heard[j]))
        elif i and cost[i][j] == cost[i - 1][j] + 1:
            i -= 1
            pairs.append((said[i], None))
        else:
            j -= 1
            pairs.append((None, heard[j]))
    return pairs


def quantiles(values):
    values = sorted(min(1, value) for value in values)
    return [round(values[round(k * (len(values) - 1) / QUANTILES)], 3) for k in range(QUANTILES + 1)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--language", default="english")
    parser.add_argument("--sentences", type=int, default=1200)
    parser.add_argument("-o", "--output", default=os.path.join(ROOT, "engine/knowledge/confusions/english.json"))
    options = parser.parse_args()
    known = pronunciations()
    texts = [text for text in examples(options.language) if words_of(text) and all(word in known for word in words_of(text))]
    confusions, right, wrong, counts = collections.defaultdict(collections.Counter), [], [], collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        write_model(os.path.join(folder, "said.lm"), [words_of(text) for text in texts])
        with open(os.path.join(folder, "said.dict"), "w", encoding="utf-8") as file:
            file.writelines(line for word in sorted({word for text in texts for word in words_of(text)}) for line in known[word])
        step = max(1, len(texts) // options.sentences)
        for number, text in enumerate(texts[::step]):
            counts["sentences"] += 1
            for said, heard in aligned(words_of(text), hear(folder, VOICES[number % len(VOICES)], text)):
                counts["words"] += said is not None
                if heard and said == heard[0]:
                    right.append(heard[1])
                    continue
                counts["dropped" if heard is None else "added" if said is None else "misheard"] += 1
                if heard:
                    wrong.append(heard[1])
                if heard and said:
                    confusions[said][heard[0]] += 1
    rows = {word: dict(sorted(sorted(heard.items()), key=lambda pair: -pair[1])[:MOST_FOR_A_WORD]) for word, heard in sorted(confusions.items())}
    os.makedirs(os.path.dirname(options.output), exist_ok=True)
    with open(options.output, "w", encoding="utf-8") as file:
        about = "words that a recogniser heard in place of others, and how sure it was; made by replay/noise/learn_confusions.py"
        file.write(f'{{\n  "confusions": 1,\n  "about": {json.dumps(about)},\n  "heard": {json.dumps(dict(sorted(counts.items())))},\n')
        file.write(f'  "confidence": {{\n    "share_wrong": {len(wrong) / (len(right) + len(wrong)):.3f},\n    "right": {quantiles(right)},\n    "wrong": {quantiles(wrong)}\n  }},\n  "words": {{\n')
        file.write(",\n".join(f"    {json.dumps(word)}: {json.dumps(heard)}" for word, heard in rows.items()))
        file.write("\n  }\n}\n")


if __name__ == "__main__":
    main()
