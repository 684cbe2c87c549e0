"""Walks the pages of a report in a browser, by keyboard and by touch, at the widths of a desk and of a phone.

Fails if a script throws, if anything is asked of the network, if a page is wider than its window, if a line or a word has
too little contrast, if a link cannot be reached or leads nowhere, or if a key or a touch does not show what it should. Needs
Chromium, and python3-websockets. `browser.py REPORT`
"""

import asyncio
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import urllib.request

import websockets

# Seconds that anything may take: machines are busy.
PATIENCE = 300
DESK, PHONE = (1280, 900), (390, 844)
KEYS = {"Tab": 9, "Enter": 13, "Escape": 27, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40}


def chromium():
    named = ["chromium", "chromium-browser", "google-chrome"]
    paths = [os.path.join(folder, name) for name in named for folder in os.environ["PATH"].split(os.pathsep)]
    return next(path for path in paths if os.access(path, os.X_OK))


class Page:
    """A tab, spoken to by the DevTools protocol."""

    def __init__(self, socket):
        self.socket, self.count, self.answers, self.faults = socket, 0, {}, []
        self.loaded = asyncio.Event()
        self.listening = asyncio.ensure_future(self.listen())

    async def listen(self):
        async for message in self.socket:
            message = json.loads(message)
            if "id" in message:
                self.answers.pop(message["id"]).set_result(message)
            else:
                self.note(message["method"], message["params"])

    def note(self, method, told):
        if method == "Page.loadEventFired":
            self.loaded.set()
        elif method == "Runtime.exceptionThrown":
            self.faults.append(told["exceptionDetails"].get("exception", told["exceptionDetails"]))
        elif method == "Runtime.consoleAPICalled" and told["type"] in ("error", "assert"):
            self.faults.append(told["args"])
        elif method == "Log.entryAdded" and told["entry"]["level"] == "error":
            self.faults.append(told["entry"])
        elif method == "Network.requestWillBeSent" and not told["request"]["url"].startswith(("file:", "data:")):
            self.faults.append("asks the network for " + told["request"]["url"])

    async def tell(self, method, **parameters):
        self.count += 1
        answer = self.answers[self.count] = asyncio.get_running_loop().create_future()
        await self.socket.send(json.dumps({"id": self.count, "method": method, "params": parameters}))
        answer = await asyncio.wait_for(answer, PATIENCE)
        assert "error" not in answer, (method, answer)
        return answer["result"]

    async def value(self, script):
        answer = await self.tell("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in answer, (script, answer)
        return answer["result"].get("value")

    async def open(self, path, size, touch):
        width, height = size
        await self.tell(
            "Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=touch
        )
        await self.tell("Emulation.setTouchEmulationEnabled", enabled=touch)
        self.loaded.clear()
        await self.tell("Page.navigate", url=path.resolve().as_uri())
        await asyncio.wait_for(self.loaded.wait(), PATIENCE)
        wide = await self.value("document.documentElement.scrollWidth - innerWidth")
        assert wide <= 0, f"{path.name} is {wide} px wider than {width}"

    async def press(self, key):
        for kind in ["rawKeyDown", "keyUp"]:
            await self.tell(
                "Input.dispatchKeyEvent", type=kind, key=key, code=key, windowsVirtualKeyCode=KEYS[key]
            )

    async def tap(self, x, y):
        await self.tell("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        await self.tell("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def well(self, where):
        assert not self.faults, f"{where}: {self.faults}"


SHOWN = "document.getElementById('what').textContent + document.getElementById('facts').textContent"
# The chart that has the focus, and where its ring stands: nothing if that cannot be seen.
RING = """(() => { const chart = document.activeElement, ring = chart && chart.querySelector && chart.querySelector('.here');
  return ring && ring.getAttribute('visibility') === 'visible' ? [ring.getAttribute('cx'), ring.getAttribute('cy')] : null })()"""


async def keyboard(page, report):
    """Every chart has its turn by Tab; arrows walk along its branch and to others; Escape lets go."""
    await page.open(report / "atlas.html", DESK, False)
    names = "[...document.querySelectorAll('svg.chart')].map(chart => chart.getAttribute('aria-label'))"
    names = await page.value(names)
    assert len(set(names)) == len(names) >= 10, names
    charts = len(names)
    for chart in range(charts):
        for _ in range(50):
            await page.press("Tab")
            at = "[...document.querySelectorAll('svg.chart')].indexOf(document.activeElement)"
            if await page.value(at) == chart:
                break
        else:
            raise AssertionError(f"Tab does not come to chart {chart}")
        seen = [(await page.value(SHOWN), await page.value(RING))]
        for key in ["ArrowRight"] * 4 + ["ArrowLeft"] + ["ArrowUp"] * 3 + ["ArrowDown"]:
            await page.press(key)
            seen.append((await page.value(SHOWN), await page.value(RING)))
        texts = {text for text, _ in seen}
        assert len(texts) >= 4, f"chart {chart}: arrows show nothing new: {texts}"
        assert any(ring for _, ring in seen), f"chart {chart}: no ring shows where one is"
        assert not any(word in text for text in texts for word in ["NaN", "undefined", "null"]), texts
        await page.press("Escape")
        page.well(f"chart {chart} by keyboard")
    return charts


async def touch(page, report):
    """A tap beside a branch of each chart shows its nearest orbit, and another tap another one."""
    await page.open(report / "atlas.html", PHONE, True)
    charts = await page.value("document.querySelectorAll('svg.chart').length")
    for chart in range(charts):
        seen = set()
        for share in [0.2, 0.5, 0.8]:
            # Near a point of a branch, in the pixels of the window.
            place = await page.value(
                f"""(() => {{ const chart = document.querySelectorAll('svg.chart')[{chart}];
                chart.scrollIntoView({{ block: 'center', behavior: 'instant' }});
                const figure = FIGURES[chart.dataset.figure], spots = figure.spots[chart.dataset.system];
                const [x, y] = spots[Math.floor({share} * (spots.length - 1))], frame = chart.getBoundingClientRect();
                return [frame.left + x * frame.width / W + 1, frame.top + y * frame.width / W - 1] }})()"""
            )
            await page.tap(*place)
            for _ in range(100):
                held = await page.value("held")
                if held:
                    break
                await asyncio.sleep(0.1)
            assert held, f"chart {chart}: a tap at {place} holds nothing"
            seen.add(await page.value(SHOWN))
        assert len(seen) >= 2, f"chart {chart}: taps show nothing new: {seen}"
        page.well(f"chart {chart} by touch")
    return charts


async def links(page, report):
    """Every link of the report is reached by Tab, and leads somewhere."""
    await page.open(report / "index.html", DESK, False)
    wanted = await page.value("document.querySelectorAll('a').length")
    reached = set()
    for _ in range(3 * wanted):
        await page.press("Tab")
        reached.add(await page.value("[...document.querySelectorAll('a')].indexOf(document.activeElement)"))
        if len(reached - {-1}) == wanted:
            break
    assert len(reached - {-1}) == wanted, f"{len(reached - {-1})} of {wanted} links by keyboard"
    for target in await page.value("[...document.querySelectorAll('a')].map(one => one.getAttribute('href'))"):
        inside = f"document.getElementById({json.dumps(target[1:])}) !== null"
        found = await page.value(inside) if target.startswith("#") else (report / target).is_file()
        assert found, f"nothing at {target}"
    return wanted


async def scriptless(page, report):
    """Without scripts the atlas leads to its figures and its data."""
    await page.tell("Emulation.setScriptExecutionDisabled", value=True)
    await page.open(report / "atlas.html", DESK, False)
    text = await page.value("document.body.innerText")
    await page.tell("Emulation.setScriptExecutionDisabled", value=False)
    assert "Figures 3.15, 3.17 and 3.18" in text, text[:500]


# The least contrast of what is drawn, and of the words of pages, with what lies under them.
INK = """(() => {
  const channels = colour => (colour.match(/[\\d.]+/g) || []).map(Number);
  const luminance = colour => channels(colour).slice(0, 3).map(part => part / 255)
    .map(part => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4)
    .reduce((sum, part, i) => sum + [0.2126, 0.7152, 0.0722][i] * part, 0);
  const clear = colour => colour === 'none' || channels(colour)[3] === 0;
  const ground = one => {
    for (let up = one; up; up = up.parentElement) {
      const under = getComputedStyle(up).backgroundColor;
      if (!clear(under)) return under;
    }
    return 'rgb(255, 255, 255)';
  };
  const contrast = (colour, under) => {
    const [low, high] = [luminance(colour), luminance(under)].sort((a, b) => a - b);
    return (high + 0.05) / (low + 0.05);
  };
  const least = { line: [99, ''], word: [99, ''] };
  const note = (kind, colour, one) => {
    const found = contrast(colour, ground(one));
    if (found < least[kind][0]) least[kind] = [found, colour + ' in ' + one.outerHTML.slice(0, 120)];
  };
  for (const one of document.querySelectorAll('svg path, svg circle, svg line, svg rect')) {
    const style = getComputedStyle(one);
    // Grids help, but say nothing.
    if (!clear(style.stroke) && parseFloat(style.strokeWidth) >= 0.7 && !one.matches('line')) note('line', style.stroke, one);
  }
  for (const one of document.querySelectorAll('svg text')) note('line', getComputedStyle(one).fill, one.ownerSVGElement);
  for (const one of document.querySelectorAll('h1, h2, h3, p, a, td, th, figcaption, dt, dd, span')) {
    if (!one.closest('svg')) note('word', getComputedStyle(one).color, one);
  }
  return least;
})()"""


async def contrast(page, report):
    """All that is drawn stands out by 3:1 at least, words of pages by 4.5:1, by day and by night."""
    least = []
    for scheme in ["light", "dark"]:
        await page.tell("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        for name in ["index.html", "atlas.html"]:
            await page.open(report / name, DESK, False)
            found = await page.value(INK)
            for kind, enough in [("line", 3.0), ("word", 4.5)]:
                assert found[kind][0] >= enough, f"{name}, {scheme}: {kind} {found[kind]}"
            least.append(found["line"][0])
    await page.tell("Emulation.setEmulatedMedia", features=[])
    return min(least)


async def walk(report, address):
    async with websockets.connect(address, max_size=None, ping_interval=None) as socket:
        page = Page(socket)
        for domain in ["Page", "Runtime", "Log", "Network"]:
            await page.tell(domain + ".enable")
        for size, mobile in [(DESK, False), (PHONE, True)]:
            await page.open(report / "index.html", size, mobile)
            figures = await page.value("document.querySelectorAll('figure svg').length")
            assert figures > 20, figures
            page.well(f"index.html at {size[0]} px")
        reached = await links(page, report)
        await scriptless(page, report)
        least = await contrast(page, report)
        keys, touches = await keyboard(page, report), await touch(page, report)
        print(f"{keys} charts walked by keyboard, {touches} by touch, {reached} links reached; contrast of lines from {least:.1f}")


def main():
    report = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = subprocess.Popen(
            [
                chromium(),
                "--headless=new",
                "--no-sandbox",
                "--disable-gpu",
                "--disable-dev-shm-usage",
                "--disable-background-networking",
                "--no-first-run",
                "--remote-debugging-port=0",
                f"--user-data-dir={profile}",
                "about:blank",
            ],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        try:
            asyncio.run(asyncio.wait_for(session(report, pathlib.Path(profile)), 20 * PATIENCE))
        finally:
            browser.kill()
            browser.wait()


async def session(report, profile):
    told = profile / "DevToolsActivePort"
    for _ in range(10 * PATIENCE):
        if told.exists() and len(told.read_text().split()) == 2:
            break
        await asyncio.sleep(0.1)
    port = told.read_text().split()[0]
    with urllib.request.urlopen(f"http://127.0.0.1:{port}/json/list", timeout=PATIENCE) as answer:
        tabs = [tab for tab in json.load(answer) if tab["type"] == "page"]
    await walk(report, tabs[0]["webSocketDebuggerUrl"])


main()
