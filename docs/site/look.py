#!/usr/bin/env python3
# SPDX-FileCopyrightText: The libhgrid developers
# SPDX-License-Identifier: BSD-3-Clause
"""Looks at a built site as a reader does, in headless Chromium: look.py [SITE [FOLDER]].

Every page is opened as wide as a phone (390 pixels) and as a screen (1400), in light and in dark colours. A fault is a
page that scrolls sideways, a picture that does not load, a script that fails, text that stands out too little from what
is behind it, a search that finds nothing. With FOLDER, some pages are photographed into it. Needs Debian's chromium,
chromium-driver and python3-selenium.
"""

import base64
import pathlib
import sys

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

SIZES = {"phone": (390, 844), "wide": (1400, 900)}
# Pictures for docs/evidence/site.md: the page, and how it is looked at.
PICTURES = {
    "site-wide": ("index", "wide", "light"),
    "site-phone": ("tutorials/first-contacts", "phone", "dark"),
    "site-reference": ("reference/c", "wide", "dark"),
}
SCALE = {"phone": 0.7, "wide": 0.5}

# What a page says of itself. Contrast is that of WCAG, of each text with the nearest background behind it.
LOOK = """
const faults = [];
const page = document.documentElement;
// Nothing is beyond the right edge but what lies in a frame of its own that scrolls.
const scrolls = element => {
  for (let e = element; e && e.tagName !== 'ARTICLE'; e = e.parentElement)
    if (['auto', 'scroll'].includes(getComputedStyle(e).overflowX)) return true;
  return false;
};
const beyond = [...document.querySelectorAll('article *')].filter(
  e => e.getBoundingClientRect().right > innerWidth + 1 && getComputedStyle(e).visibility !== 'hidden' && !scrolls(e));
if (page.scrollWidth > page.clientWidth || beyond.length)
  faults.push(`scrolls sideways (${page.scrollWidth} pixels): ` +
    beyond.slice(0, 3).map(e => `${e.tagName}.${e.className} ${e.textContent.trim().slice(0, 30)}`).join(', '));
for (const image of document.images)
  if (image.loading !== 'lazy' && !(image.complete && image.naturalWidth)) faults.push('no picture ' + image.src);
const channels = text => (text.match(/[\\d.]+/g) || []).map(Number);
const light = ([r, g, b]) => [r, g, b].map(c => (c /= 255) <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
  .reduce((sum, c, k) => sum + c * [0.2126, 0.7152, 0.0722][k], 0);
const behind = element => {
  for (let e = element; e; e = e.parentElement) {
    const color = channels(getComputedStyle(e).backgroundColor);
    if (color.length === 3 || color[3] > 0.9) return color;
  }
  return [255, 255, 255];
};
const low = new Set();
for (const element of document.querySelectorAll('article p, article a, article td, article th, article li, h1, h2, h3, pre span')) {
  if (!element.textContent.trim() || !element.getClientRects().length) continue;
  const [a, b] = [light(channels(getComputedStyle(element).color)), light(behind(element))];
  const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  if (ratio < LOWEST) low.add(`${element.tagName}.${element.className} ${ratio.toFixed(1)}`);
}
if (low.size) faults.push('low contrast: ' + [...low].slice(0, 3).join(', '));
return faults;
""".replace("LOWEST", "3")


def browser():
    options = Options()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--allow-file-access-from-files"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "SEVERE"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


def shape(driver, size, colors):
    width, height = SIZES[size]
    # Not as a mobile device: that one widens the page until it need not scroll.
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                           {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia",
                           {"media": "", "features": [{"name": "prefers-color-scheme", "value": colors}]})


def photograph(driver, site, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, (page, size, colors) in PICTURES.items():
        shape(driver, size, colors)
        driver.get((site / f"{page}.html").as_uri())
        width, height = SIZES[size]
        clip = {"x": 0, "y": 0, "width": width, "height": height, "scale": SCALE[size]}
        taken = driver.execute_cdp_cmd("Page.captureScreenshot", {"format": "png", "clip": clip})
        (folder / f"{name}.png").write_bytes(base64.b64decode(taken["data"]))


def found_by_search(driver, site, word):
    driver.get(f"{(site / 'search.html').as_uri()}?q={word}")
    for _ in range(100):
        links = driver.execute_script("return [...document.querySelectorAll('#search-results li a')].length")
        done = driver.execute_script("return !document.querySelector('#search-progress')?.textContent.includes('.')")
        if links and done:
            return links
        driver.execute_async_script("setTimeout(arguments[0], 100)")
    return 0


def main():
    site = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "build/site").resolve()
    names = sorted(path.relative_to(site).with_suffix("").as_posix() for path in site.rglob("*.html"))
    driver, faults = browser(), []
    try:
        for size in SIZES:
            for colors in ("light", "dark"):
                shape(driver, size, colors)
                for name in names:
                    driver.get((site / f"{name}.html").as_uri())
                    faults += [f"{name}, {size}, {colors}: {fault}" for fault in driver.execute_script(LOOK)]
                    faults += [f"{name}: {entry['message']}" for entry in driver.get_log("browser")]
        if len(sys.argv) > 2:
            photograph(driver, site, pathlib.Path(sys.argv[2]))
        for word in ("hg_query_pairs", "periodic", "skin"):
            found = found_by_search(driver, site, word)
            print(f"search for {word}: {found} pages")
            faults += [] if found else [f"the search finds nothing about {word}"]
    finally:
        driver.quit()
    for fault in dict.fromkeys(faults):
        print("FAULT", fault)
    print(f"{len(names)} pages, {len(faults)} faults")
    return 1 if faults or len(names) < 50 else 0


if __name__ == "__main__":
    sys.exit(main())
