// Walks the pages of a report by keyboard and by touch, as their readers do, in a browser without a network.
//
//     npm install && node walk.mjs ../../report [chromium]

import { readdirSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import puppeteer from "puppeteer-core";

const folder = resolve(process.argv[2] ?? "../../report");
const executablePath = process.argv[3] ?? "/usr/bin/chromium";
const faults = [];
let checks = 0;

function expect(holds, what) {
  checks += 1;
  if (!holds) faults.push(what);
}

const browser = await puppeteer.launch({ executablePath, args: ["--no-sandbox"] });

/** A page of the report, on which every error and every request to elsewhere is a fault. */
async function open(name, viewport) {
  const page = await browser.newPage();
  page.on("pageerror", error => faults.push(`${name}: ${error}`));
  page.on("console", message => message.type() === "error" && faults.push(`${name}: ${message.text()}`));
  page.on("request", request => /^(file|data):/.test(request.url()) || faults.push(`${name} asks for ${request.url()}`));
  await page.setViewport(viewport);
  await page.goto(pathToFileURL(`${folder}/${name}`).href);
  return page;
}

const DESK = { width: 1200, height: 900 };
const PHONE = { width: 390, height: 844, isMobile: true, hasTouch: true };

/** What the pane says of the orbit that is shown, and where it is marked. */
const shown = page => page.evaluate(() => ({
  facts: document.getElementById("facts").textContent,
  marked: [...document.querySelectorAll(".here")].filter(here => here.getAttribute("visibility") === "visible").length,
  finite: !/NaN|undefined|Infinity/.test(document.querySelector(".layout").innerHTML),
  here: document.activeElement.getAttribute("aria-label"),
}));

async function keyboard() {
  const page = await open("atlas.html", DESK);
  const charts = await page.$$eval("svg.chart", all => all.map(one => one.getAttribute("aria-label")));
  expect(charts.length === 10 && new Set(charts).size === 10, `ten charts with names of their own: ${charts}`);
  const met = new Set();
  for (let tab = 0; tab < charts.length + 5; tab++) {
    await page.keyboard.press("Tab");
    const begin = await shown(page);
    if (!charts.includes(begin.here)) continue;
    met.add(begin.here);
    const seen = new Set([begin.facts]);
    for (const key of ["ArrowRight", "ArrowRight", "ArrowUp", "ArrowRight", "ArrowDown", "ArrowLeft"]) {
      await page.keyboard.press(key);
      const now = await shown(page);
      expect(now.finite && now.here === begin.here, `${begin.here}, ${key}: ${JSON.stringify(now)}`);
      expect(now.marked > 0, `${begin.here}, ${key}: no point is marked`);
      seen.add(now.facts);
    }
    expect(seen.size >= 4, `${begin.here}: the arrows show ${seen.size} orbits`);
    await page.keyboard.press("Escape");
  }
  expect(met.size === charts.length, `by Tab alone one comes to ${[...met]}`);
  await page.close();
}

async function touch() {
  const page = await open("atlas.html", PHONE);
  const charts = await page.$$("svg.chart");
  let answered = 0;
  for (const chart of charts) {
    await chart.evaluate(one => one.scrollIntoView({ block: "center" }));
    const before = (await shown(page)).facts;
    const frame = await chart.boundingBox();
    for (const share of [0.3, 0.5, 0.7]) for (const up of [0.3, 0.5, 0.7]) {
      await page.touchscreen.tap(frame.x + share * frame.width, frame.y + up * frame.height);
    }
    answered += Number((await shown(page)).facts !== before);
    expect((await shown(page)).finite, "a touch shows what is no number");
  }
  expect(answered === charts.length, `${answered} of ${charts.length} charts answer a touch`);
  await page.close();
}

/** What is wider than the page can be moved by itself; the page stays. */
async function narrow(name) {
  const page = await open(name, PHONE);
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  expect(width <= PHONE.width, `${name} is ${width} px wide on a phone`);
  await page.close();
}

/** Every link within the report is reached by keyboard, and leads somewhere; tables can be moved. */
async function links() {
  const page = await open("index.html", DESK);
  const wanted = await page.$$eval("a", all => all.length);
  const reached = new Set();
  for (let tab = 0; tab < 2 * wanted; tab++) {
    await page.keyboard.press("Tab");
    const at = await page.evaluate(() => [...document.querySelectorAll("a")].indexOf(document.activeElement));
    if (at >= 0 && reached.has(at)) break;
    if (at >= 0) reached.add(at);
  }
  expect(reached.size === wanted, `${reached.size} of ${wanted} links by keyboard`);
  const lost = await page.$$eval("a[href^='#']", all => all.map(one => one.hash).filter(hash => !document.querySelector(hash)));
  expect(lost.length === 0, `nothing at ${lost}`);
  const files = new Set(readdirSync(folder, { recursive: true }).map(name => name.replaceAll("\\", "/")));
  const local = await page.$$eval("a", all => all.map(one => one.getAttribute("href")).filter(href => !href.startsWith("#")));
  for (const href of local) expect(files.has(href), `there is no ${href}`);
  await page.close();
}

/** Without scripts the atlas still leads to its figures and its data. */
async function scriptless() {
  const page = await browser.newPage();
  await page.setJavaScriptEnabled(false);
  await page.goto(pathToFileURL(`${folder}/atlas.html`).href);
  const text = await page.$eval("body", body => body.innerText);
  expect(text.includes("Figures 3.15, 3.17 and 3.18"), "without scripts the atlas says nothing");
  await page.close();
}

await keyboard();
await touch();
await narrow("index.html");
await narrow("atlas.html");
await links();
await scriptless();
await browser.close();
faults.forEach(fault => console.error(fault));
console.log(`${checks - Math.min(checks, faults.length)} passed, ${faults.length} failed`);
process.exitCode = faults.length ? 1 : 0;
